// Colours a mesh by the strips of its file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "meshes/soup.hpp"
#include "restrip/mesh/strip_mesh.hpp"

namespace restrip::tools {

struct FileStrips {
  std::size_t solid = 0;  ///< dual edges that became solid
  std::size_t cut = 0;    ///< places within a strip at which consecutive triangles share no dual edge
};

/// Colours a mesh built from the soup according to the strips of its file: consecutive triangles of a strip are joined
/// if they share a dual edge. They do not if the mesh is not manifold or not oriented there. Two or more degenerate
/// triangles in a row stitch strips together, so another strip begins. `origin` is the array from StripMesh::build. All
/// dual edges must be dashed; the colouring is valid afterwards. Linear time.
FileStrips color_as_in_file(StripMesh& mesh, const Soup& soup, std::span<const std::uint32_t> origin);

}  // namespace restrip::tools
