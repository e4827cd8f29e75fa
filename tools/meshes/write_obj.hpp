// Wavefront OBJ out: `v`, with colours behind the coordinates as most programs read them, `vt`, `vn` and `f`.
#pragma once

#include <string>

#include "meshes/soup.hpp"

namespace restrip::tools {

/// Numbers as text that reads back the same, colours as 0 to 1. Vertices at one place that differ in normals or texture
/// coordinates alone share their `v`, so that other programs see one surface; those that differ in nothing do not. OBJ
/// counts the second texture coordinate from below, glTF and Soup from above: it is turned.
[[nodiscard]] std::string obj_bytes(const Soup& soup);

}  // namespace restrip::tools
