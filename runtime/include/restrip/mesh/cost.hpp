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

#include "restrip/mesh/mesh.hpp"

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

/// True when the dual edge of h, which must be solid, is a swap: both of its triangles have two solid edges, and the
/// strip turns the same way in both. Constant time, four colours.
template <ColoredMesh Mesh>
[[nodiscard]] constexpr bool is_swap(const Mesh& mesh, typename Mesh::Halfedge h) {
  const auto back = mesh.opposite(h);
  const auto right = mesh.next(h);
  const auto right_back = mesh.next(back);
  const bool turns_right = mesh.solid(right);
  const bool turns_right_back = mesh.solid(right_back);
  // Seen from the shared edge the triangles are mirrored, so equal turns appear on opposite sides.
  return turns_right != turns_right_back && (turns_right || mesh.solid(mesh.next(right))) &&
         (turns_right_back || mesh.solid(mesh.next(right_back)));
}

}  // namespace restrip
