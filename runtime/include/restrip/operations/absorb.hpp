// Absorbs a triangle that an operation left isolated into the strip of a neighbour that can spare an end.
//
// Splits and collapses inside the mesh never add an isolated triangle (proved for fans of up to eight triangles, tested
// for larger ones). On its boundary, and in flips, even the optimal rule sometimes must, because it reads and writes
// only its patch. Looking one triangle further helps: the edge between the isolated triangle x and a neighbour t is
// set, and t loses one of its two solid edges, to a triangle that has another solid edge. The number of strips stays
// the same, no other triangle becomes isolated, and no cycle can close, because x had no solid edge.
//
// Call it after an operation whose Rewrite has `isolated > 0`, or after any flip. It writes colours outside the patch,
// so operations that use it do not commute with their neighbours. Constant time a triangle, and rarely needed.
#pragma once

#include "restrip/mesh/strip_mesh.hpp"
#include "restrip/operations/result.hpp"

namespace restrip {

/// How often absorb() passes an isolated triangle on.
inline constexpr int default_absorptions = 4;

/// Absorbs the triangle to the left of h if it is isolated and a neighbour can take it. If every neighbour would have
/// to isolate another triangle, one of them does, and that triangle is absorbed in turn, `depth` times at most. If that
/// fails as well, nothing has changed.
ColoringChange absorb(StripMesh& mesh, Halfedge h, int depth = default_absorptions);

}  // namespace restrip
