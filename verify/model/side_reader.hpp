#pragma once
// Reads a side of an operation in any of the forms in docs/reference/operation-file.md.

#include "common/json.hpp"
#include "model/operation.hpp"
#include "model/triangles.hpp"

namespace restrip::verify {

/// The numbers of a family with their values at one position.
struct NamedNumbers {
  const std::vector<std::string>& names;
  const Numbers& values;
};

/// "t[0,k)": the name and the range, whose end is exclusive.
struct NamedRange {
  std::string name;
  unsigned from = 0;
  unsigned to = 0;
};
/// Throws std::invalid_argument with a sentence.
NamedRange range_of(const std::string& text, const NamedNumbers& numbers);

/// The sides of a description at one position.
Sides read_sides(const JsonValue& description, const NamedNumbers& numbers);

/// Reads sides given by triangles (docs/reference/operation-file.md, "Triangles"), which have indices in a family
/// ("Families"). Throws files::FileError if they are not an operation on a mesh.
Sides read_surface(const JsonValue& description, const NamedNumbers& numbers);

/// A graph, or triangles around rings and along paths. Throws files::FileError, also if the limits are exceeded.
Side read_side(const JsonValue& value, const NamedNumbers& numbers);

}  // namespace restrip::verify
