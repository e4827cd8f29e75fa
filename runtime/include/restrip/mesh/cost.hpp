// The cost of a colouring: a weight for each strip, each swap and each isolated triangle.
//
// An index buffer of plain triangle strips with primitive restart holds T + 3 S + W + X - 1 indices: T triangles, S
// strips (two indices to begin with, one restart), W *swaps* and X strips that begin with the wrong turn. The *turn* of
// a strip at a triangle is clockwise or counter-clockwise, from the side it enters by to the side it leaves by; two
// consecutive triangles that turn the same way repeat one index (Evans, Skiena, Varshney, "Optimizing triangle strips
// for fast rendering", 1996). A strip can be written from either end. If it begins with a turn to the right from both
// ends, its winding takes one more index. X, at most S, is a property of whole strips, not part of the cost.
//
// So Cost::indices() is the length of the index buffer except for T - 1 and X, and Cost::strips() is the number of
// strips. Other formats have other weights.
#pragma once

#include <cstdint>

#include "restrip/mesh/strip_mesh.hpp"

namespace restrip {

/// The cost of a colouring with S strips, W swaps and I isolated triangles: restart * S + swap * W + isolated * I.
/// Among colourings of equal cost the library prefers fewer isolated triangles if its method counts them.
struct Cost {
  std::uint16_t restart = 1;   ///< of each strip
  std::uint16_t swap = 0;      ///< of each swap
  std::uint16_t isolated = 0;  ///< of each isolated triangle, in addition to the restart of its strip

  [[nodiscard]] static constexpr Cost strips() noexcept { return {1, 0, 0}; }
  [[nodiscard]] static constexpr Cost indices() noexcept { return {3, 1, 0}; }
  friend constexpr bool operator==(const Cost&, const Cost&) = default;
};

/// The cost that is minimised by default.
inline constexpr Cost default_cost = Cost::indices();

/// The change of a colouring, in counts. Operations and repairs that do not say that they count swaps leave them 0.
struct ColoringChange {
  int strips = 0;    ///< change in the number of strips
  int swaps = 0;     ///< change in the number of swaps
  int isolated = 0;  ///< change in the number of isolated triangles of the whole mesh

  constexpr ColoringChange& operator+=(const ColoringChange& more) noexcept {
    strips += more.strips;
    swaps += more.swaps;
    isolated += more.isolated;
    return *this;
  }
  [[nodiscard]] constexpr ColoringChange operator-() const noexcept { return {-strips, -swaps, -isolated}; }
  [[nodiscard]] constexpr std::int32_t price(const Cost& cost) const noexcept {
    return std::int32_t{cost.restart} * strips + std::int32_t{cost.swap} * swaps +
           std::int32_t{cost.isolated} * isolated;
  }
  friend constexpr bool operator==(const ColoringChange&, const ColoringChange&) = default;
};

namespace detail {

/// Solid dual edges of the triangle to the left of h.
inline unsigned solid_degree(const StripMesh& mesh, Halfedge h) { return mesh.solid_degree(StripMesh::triangle(h)); }

/// Whether a solid edge is a swap, from the turns on its two sides. Seen from the shared edge the triangles are
/// mirrored, so equal turns appear on opposite sides.
constexpr int is_swap(unsigned turn, unsigned turn_back) noexcept { return int{(turn ^ turn_back) == 3}; }

}  // namespace detail

/// True when the dual edge of h, which must be solid, is a swap: both of its triangles have two solid edges, and the
/// strip turns the same way in both. Constant time, four colours.
[[nodiscard]] inline bool is_swap(const StripMesh& mesh, Halfedge h) {
  return detail::is_swap(mesh.other_solid_sides(h), mesh.other_solid_sides(mesh.opposite(h))) != 0;
}

}  // namespace restrip
