// A lower bound on the indices of any strip index buffer, with a proof that only needs additions.
//
//   const IndexBound bound = strip_index_lower_bound(mesh);
//   bound.indices                       // every index buffer of these triangles has at least this many
//   bound.cuts                          // the proof: docs/explanation/theory.md, "Lower bound on indices"
//
// An index serves at most three consecutive triangles. At strip ends and swaps it serves fewer: two are missing at one
// vertex and one at a neighbour, an arrow along a mesh edge. The number missing at a vertex of n triangles is -n modulo
// 3. So the arrows are a flow modulo 3, and cross the border of every set of vertices whose triangles do not add up to
// a multiple of three. The search packs such sets.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "restrip/mesh/strip_mesh.hpp"

namespace restrip {

/// A set of vertices and the multiplier of its border.
struct VertexCut {
  std::vector<Vertex> vertices;  ///< ascending
  std::uint32_t multiplier = 0;  ///< 1 … IndexBound::denominator
};

struct IndexBound {
  static constexpr std::uint32_t denominator = 3U << 18;  ///< of all multipliers

  std::size_t triangles = 0;
  std::size_t components = 0;  ///< of the mesh; triangles that share a vertex are connected
  std::size_t arrows = 0;      ///< a lower bound: the sum of all multipliers over the denominator, rounded up
  std::size_t indices = 0;     ///< triangles + arrows + components - 1; 0 without triangles
  std::vector<VertexCut> cuts;
};

/// The number of rounds that brings the bound within a thousandth of the best that these sets can give, on three meshes
/// of 13,000 to 70,000 triangles.
inline constexpr unsigned thorough_bound = 4;

/// A lower bound on the indices of strips with primitive restart that draw each triangle exactly once and nothing else;
/// degenerate triangles are allowed, and windings do not matter. Corners must differ within a triangle and be less than
/// `vertex_count`; the mesh need not be manifold. The bound is at least the sum of ceil(n / 3) over all vertices, for n
/// triangles at the vertex, plus the restarts between components.
///
/// `rounds`: 0 uses only single vertices. Each round adds edges, triangles and balls of vertices that the fewest arrows
/// so far would not cross; four rounds take some fifteen times as long as none. O(n log n) for n triangles; about 150
/// bytes a triangle without rounds, 300 with four. The arithmetic is in whole numbers, so the result is the same on
/// every machine.
[[nodiscard]] IndexBound strip_index_lower_bound(std::span<const std::array<Vertex, 3>> triangles,
                                                 std::size_t vertex_count, unsigned rounds = thorough_bound);

/// The bound for the triangles of a mesh. Its colours do not matter.
[[nodiscard]] IndexBound strip_index_lower_bound(const StripMesh& mesh, unsigned rounds = thorough_bound);

}  // namespace restrip

#include "restrip/output/impl/index_bound.hpp"
