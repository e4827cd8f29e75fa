#pragma once
// Reads the sides of an operation that is given by its triangles (docs/operation-file.md, "Triangles"), or of a family
// whose triangles have vertices with indices ("Families").

#include "model/side_reader.hpp"

namespace restrip::verify {

/// At one position. InputError when they are no operation on a mesh.
Sides read_surface(const JsonValue& description, const NamedNumbers& numbers);

}  // namespace restrip::verify
