// The second halves of operations that join strip ends, and the triangles of a fan that bits name.
#pragma once

#include <bit>
#include <cstddef>
#include <span>

#include "restrip/operations/impl/halves.hpp"
#include "restrip/operations/impl/patch_sides.hpp"
#include "restrip/operations/join.hpp"

namespace restrip::detail {

/// The triangles of a ring with chord that `elements` names, each by its halfedge that leaves the vertex of the fan,
/// for A and D by the chord.
template <class Visit>
void visit_ring(const StripMesh& mesh, const InteriorFan& fan, Halfedge chord, Word elements, Visit&& visit) {
  for (; elements != 0; elements &= elements - 1) {
    const auto element = static_cast<std::size_t>(std::countr_zero(elements));
    const bool second = element > fan.a;  // D, and the triangles of the second arc
    const auto side = second ? mesh.opposite(chord) : chord;
    const std::size_t after = second ? element - (fan.a + 1) : element;
    if (after == 0)
      visit(side);
    else if (after == 1)
      visit(mesh.opposite(mesh.next(mesh.next(side))));
    else
      visit(fan.spokes[(second ? fan.a : 0) + after - 2]);
  }
}
/// The triangles of the fan that a collapse leaves; `left` is its spoke to v_l.
template <class Visit>
void visit_fan(const StripMesh& mesh, const InteriorFan& fan, Halfedge left, Word triangles, Visit&& visit) {
  for (; triangles != 0; triangles &= triangles - 1) {
    const auto i = static_cast<std::size_t>(std::countr_zero(triangles));
    if (i == 0)
      visit(left);
    else if (i == fan.a)
      visit(turn_ccw(mesh, i > 1 ? fan.spokes[i - 2] : left));
    else
      visit(fan.spokes[i - 1]);
  }
}

/// finish_split() and finish_collapse(), then steps 1 to 3 of join.hpp.
Rewrite finish_split_and_join(StripMesh& mesh, const FanChange& change, Halfedge chord);
Rewrite finish_collapse_and_join(StripMesh& mesh, const FanChange& change, Halfedge left);
/// Steps 1 to 3 for the triangles to the left of some halfedges, each once; boundary halfedges are skipped.
ColoringChange join_in(StripMesh& mesh, std::span<Halfedge> nearby);
/// Steps 1 to 3 in the triangles that a table's operation has made, of which `first` is the first side, and in their
/// neighbours, which may have lost a port.
ColoringChange join_patch(StripMesh& mesh, const OperationView& table, Halfedge first);

}  // namespace restrip::detail
