// What no index buffer of strips can beat, with a proof that needs additions alone.
//
//   const IndexBound bound = strip_index_lower_bound(mesh);
//   bound.indices                       // no index buffer of these triangles has fewer
//   bound.cuts                          // why: docs/explanation/theory.md, "Lower bound on indices"
//
// An index serves at most three consecutive triangles. Where one serves fewer, at the ends of a strip and at swaps, two
// are missing at one vertex and one at a neighbour: an arrow along a mesh edge. What is missing at a vertex of n
// triangles is -n modulo 3, so the arrows are a flow modulo 3, and the border of every set of vertices whose triangles
// do not add up to a multiple of three is crossed by arrows. A largest packing of such sets is searched for.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "restrip/mesh/strip_mesh.hpp"

namespace restrip {

/// A set of vertices and how much its border counts.
struct VertexCut {
  std::vector<Vertex> vertices;  ///< ascending
  std::uint32_t multiplier = 0;  ///< 1 … IndexBound::denominator
};

struct IndexBound {
  static constexpr std::uint32_t denominator = 3U << 18;  ///< of all multipliers

  std::size_t triangles = 0;
  std::size_t components = 0;  ///< of the mesh, where triangles that share a vertex are connected
  std::size_t arrows = 0;      ///< a lower bound: the sum of all multipliers over the denominator, rounded up
  std::size_t indices = 0;     ///< triangles + arrows + components - 1; 0 without triangles
  std::vector<VertexCut> cuts;
};

/// As many rounds as bring the bound within a thousandth of what these sets can give, on three meshes of 13,000 to
/// 70,000 triangles.
inline constexpr unsigned thorough_bound = 4;

/// A number of indices below which no index buffer draws each triangle exactly once and nothing else: triangle strips
/// with primitive restart, degenerate triangles allowed, whatever their winding. Corners must differ within a triangle
/// and be less than `vertex_count`; the triangles may be any that are so, manifold or not. At least the sum of ceil(n /
/// 3) over all vertices, where n is the number of triangles of the vertex, and the restarts between components.
///
/// `rounds`: 0 looks at single vertices alone. Each round adds edges, triangles and balls of vertices that arrows as
/// few as they are so far would not cross; four rounds take some fifteen times as long as none. O(n log n) for n
/// triangles; about 150 bytes a triangle without rounds, 300 with four. Whole numbers throughout, so the result is the
/// same on every machine.
[[nodiscard]] IndexBound strip_index_lower_bound(std::span<const std::array<Vertex, 3>> triangles,
                                                 std::size_t vertex_count, unsigned rounds = thorough_bound);

/// The bound for the triangles of a mesh. Its colours do not matter.
[[nodiscard]] IndexBound strip_index_lower_bound(const StripMesh& mesh, unsigned rounds = thorough_bound);

}  // namespace restrip

#include "restrip/output/impl/index_bound.hpp"
