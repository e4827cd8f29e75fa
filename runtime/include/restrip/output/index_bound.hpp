// What no strips can beat.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "restrip/mesh/strip_mesh.hpp"
#include "restrip/mesh/walks.hpp"

namespace restrip {

/// The least indices that an index buffer of strips with primitive restart can have for the triangles of the mesh,
/// whatever the strips: at least so many, often a few of a hundred more. Each index is a corner of at most three
/// consecutive triangles, so a vertex of n triangles is named at least ceil(n / 3) times; and a restart lies between
/// two strips, of which each connected component has one at least. Linear time.
[[nodiscard]] inline std::size_t strip_index_lower_bound(const StripMesh& mesh) {
  std::vector<std::uint32_t> around(mesh.vertex_bound(), 0);
  for (Triangle t = 0; t < mesh.triangle_bound(); ++t)
    if (mesh.alive(t))
      for (const Vertex v : mesh.corners(t)) ++around[v];
  std::size_t indices = 0;
  for (const std::uint32_t triangles : around) indices += (triangles + std::size_t{2}) / 3;
  const std::size_t components = connected_components(mesh);
  return components == 0 ? 0 : indices + components - 1;
}

}  // namespace restrip
