// The strips that a file has, as the colouring of its mesh.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "meshes/soup.hpp"
#include "restrip/mesh/strip_mesh.hpp"

namespace restrip::tools {

struct FileStrips {
  std::size_t solid = 0;  ///< dual edges that became solid
  std::size_t cut = 0;    ///< places within a strip where two triangles that follow each other share no dual edge
};

/// Colours a mesh built from the soup as the strips of its file say: triangles that follow each other in a strip are
/// joined where they share a dual edge. They do not where the mesh is not manifold or not oriented. Where two or more
/// degenerate triangles stitch strips together, another strip begins. `origin` is that of StripMesh::build. The dual
/// edges must be dashed; the colouring is valid afterwards. Linear time.
FileStrips color_as_in_file(StripMesh& mesh, const Soup& soup, std::span<const std::uint32_t> origin);

}  // namespace restrip::tools
