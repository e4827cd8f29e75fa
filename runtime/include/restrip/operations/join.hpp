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
// split_and_join(), collapse_and_join() and flip_and_join(). It bounds the number of strips of the whole mesh at every
// moment: docs/explanation/theory.md, "What holds for the whole mesh". join_all() establishes the property.
//
// The only state is the colours, and nothing is allocated. Colours outside the patch are read and written, so unlike
// the operations of operations.hpp these do not commute with their neighbours.
#pragma once

#include "restrip/mesh/strip_mesh.hpp"
#include "restrip/operations/result.hpp"

namespace restrip {

/// Whether the triangles to the left of g and h, which must be two strip ends or isolated triangles, are ends of one
/// strip. Time linear in the shorter strip.
[[nodiscard]] bool same_strip(const StripMesh& mesh, Halfedge g, Halfedge h);

/// If a strip ends in the triangle to the left of h, joins it with adjacent ends of other strips: at most two. Time
/// linear in the shorter strip of each pair that meets.
ColoringChange join_end(StripMesh& mesh, Halfedge h);

/// Joins all ends that meet in the whole mesh. Time: the number of triangles times the mean length of strips that end
/// next to each other.
ColoringChange join_all(StripMesh& mesh);

/// Steps 1 to 3 above, for custom operations and the operations of refine.hpp, after the operation: around the vertex
/// that h leaves; or in the two triangles at the edge of h and their neighbours, where ports may have been cleared.
ColoringChange join_around(StripMesh& mesh, Halfedge h);
ColoringChange join_at_edge(StripMesh& mesh, Halfedge h);

/// split(), then steps 1 to 3. The Rewrite includes all changes.
Rewrite split_and_join(StripMesh& mesh, const VertexSplit& where, Vertex new_vertex = none);

/// collapse(), likewise.
Rewrite collapse_and_join(StripMesh& mesh, Halfedge chord);

/// flip(), likewise.
Rewrite flip_and_join(StripMesh& mesh, Halfedge h);

}  // namespace restrip
