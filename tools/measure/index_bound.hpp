// A lower bound on the indices of any strip index buffer: docs/explanation/theory.md, "Lower bound on indices".
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "common/disjoint_sets.hpp"
#include "restrip/mesh/strip_mesh.hpp"

namespace restrip::tools {

/// A lower bound on the indices of strips with primitive restart that draw each triangle exactly once and nothing else:
/// the sum of ceil(n / 3) over all vertices, for n triangles at the vertex, and an index between two components
/// (triangles that share a vertex are connected). Degenerate triangles in the buffer are allowed, and windings do not
/// matter. Corners must differ within a triangle and be less than `vertex_count`; the mesh need not be manifold. Nearly
/// linear time.
[[nodiscard]] inline std::size_t strip_index_lower_bound(std::span<const std::array<Vertex, 3>> triangles,
                                                         std::size_t vertex_count) {
  std::vector<std::uint32_t> around(vertex_count, 0);
  DisjointSets components(vertex_count);
  for (const auto& corners : triangles)
    for (const Vertex v : corners) {
      ++around[v];
      components.unite(corners[0], v);
    }
  std::size_t indices = 0;
  for (Vertex v = 0; v < vertex_count; ++v) {
    indices += (around[v] + std::size_t{2}) / 3;
    if (around[v] != 0 && components.find(v) == v) ++indices;
  }
  return triangles.empty() ? 0 : indices - 1;
}

/// The bound for the triangles of a mesh. Its colours do not matter.
[[nodiscard]] inline std::size_t strip_index_lower_bound(const StripMesh& mesh) {
  std::vector<std::array<Vertex, 3>> triangles;
  triangles.reserve(mesh.triangle_count());
  for (Triangle t = 0; t < mesh.triangle_bound(); ++t)
    if (mesh.alive(t)) triangles.push_back(mesh.corners(t));
  return strip_index_lower_bound(triangles, mesh.vertex_bound());
}

}  // namespace restrip::tools
