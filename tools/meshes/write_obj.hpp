// Writes Wavefront OBJ: `v`, followed by colours in the usual extension, `vt`, `vn` and `f`.
#pragma once

#include <string>

#include "meshes/soup.hpp"

namespace restrip::tools {

/// Numbers read back exactly; colours range from 0 to 1. Vertices at one position that differ only in normals or
/// texture coordinates share a `v`, so that other programs see a connected surface. Identical vertices do not share
/// one. OBJ counts the second texture coordinate from below, glTF and Soup from above, so it is inverted.
[[nodiscard]] std::string obj_bytes(const Soup& soup);

}  // namespace restrip::tools
