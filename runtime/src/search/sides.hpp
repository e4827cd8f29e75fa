// Sides of triangles as bits of a mask.
#pragma once

#include <bit>

#include "restrip/mesh/strip_mesh.hpp"

namespace restrip::detail {

/// The lowest of some sides of t, a mask that is not 0.
inline StripMesh::Halfedge lowest_side(Triangle t, unsigned sides) noexcept {
  return StripMesh::halfedge(t, static_cast<unsigned>(std::countr_zero(sides)));
}
/// Whether a strip ends in a triangle with these solid sides: it has at most one.
constexpr bool is_strip_end(unsigned solid) noexcept { return (0b00010111U >> solid & 1U) != 0; }

}  // namespace restrip::detail
