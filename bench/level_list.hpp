// The triangles of one level as a list: the input for making strips, or an order, from scratch.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "restrip/mesh/strip_mesh.hpp"

namespace restrip::bench {

struct LevelList {
  std::vector<std::uint32_t> indices;  ///< three a triangle; vertices are numbered by appearance
  std::size_t vertices = 0;
  StripMesh mesh;  ///< the same triangles
};

/// The list of the level with `percent` of the finest triangles. Made on first use, and kept.
[[nodiscard]] const LevelList& level_list(const std::string& name, int percent);

}  // namespace restrip::bench
