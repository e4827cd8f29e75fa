// Joins: adjacent ends of different strips are joined into one strip.
//
// A rule may leave two strip ends that meet across a dashed edge. A walk from both ends at once finds whether they
// belong to two strips, in at most one step for each triangle of the shorter strip (the whole strip, if both are its
// ends). After an operation three steps follow:
//  1. If a strip was cut, its far ends may be neighbours that now belong to two strips. They are found by following all
//     strips that end around the operation in parallel, until at most one has not reached its other end, and joined
//     there.
//  2. Ends in the patch, and outside cleared ports, are joined with the ends next to them.
//  3. Triangles that are still isolated are absorbed (absorb.hpp), and the ends left by this go through 1 and 2.
//
// Guarantee. A mesh in which no dashed edge joins ends of two different strips keeps this property under
// Policy::local. It bounds the number of strips of the whole mesh at every moment: docs/explanation/theory.md, "What
// holds for the whole mesh".
//
// The only state is the colours, and nothing is allocated. Colours outside the patch are read and written, so unlike
// the operations of operations.hpp these do not commute with their neighbours.
#pragma once

#include <bit>
#include <cstddef>
#include <span>

#include "operations/halves.hpp"
#include "operations/patch_sides.hpp"
#include "restrip/mesh/strip_mesh.hpp"
#include "restrip/operations/result.hpp"

namespace restrip::detail {

/// Whether the triangles to the left of g and h, which must be two strip ends or isolated triangles, are ends of one
/// strip. Time linear in the shorter strip.
[[nodiscard]] bool same_strip(const StripMesh& mesh, Halfedge g, Halfedge h);

/// If a strip ends in the triangle to the left of h, joins it with adjacent ends of other strips: at most two. Time
/// linear in the shorter strip of each pair that meets.
ColoringChange join_end(StripMesh& mesh, Halfedge h);

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

/// finish_split() and finish_collapse(), then steps 1 to 3.
Rewrite finish_split_and_join(StripMesh& mesh, const FanChange& change, Halfedge chord);
Rewrite finish_collapse_and_join(StripMesh& mesh, const FanChange& change, Halfedge left);
/// Steps 1 to 3 for the triangles to the left of some halfedges, each once; boundary halfedges are skipped.
ColoringChange join_in(StripMesh& mesh, std::span<Halfedge> nearby);
/// Steps 1 to 3 in the two triangles at the edge of h and their neighbours, where ports may have been cleared.
ColoringChange join_at_edge(StripMesh& mesh, Halfedge h);
/// Steps 1 to 3 in the triangles that a table's operation has made, of which `first` is the first side, and in their
/// neighbours, which may have lost a port.
ColoringChange join_patch(StripMesh& mesh, const OperationView& table, Halfedge first);

}  // namespace restrip::detail
