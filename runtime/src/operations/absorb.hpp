// Absorbs a triangle that an operation left isolated into the strip of a neighbour that can spare an end.
//
// Splits and collapses inside the mesh never add an isolated triangle (proved for fans of up to eight triangles, tested
// for larger ones). On its boundary, and in flips, even the optimal rule sometimes must, because it reads and writes
// only its patch. Looking one triangle further helps: the edge between the isolated triangle x and a neighbour t is
// set, and t loses one of its two solid edges, to a triangle that has another solid edge. The number of strips stays
// the same, no other triangle becomes isolated, and no cycle can close, because x had no solid edge.
#pragma once

#include "restrip/mesh/cost.hpp"
#include "restrip/mesh/strip_mesh.hpp"
#include "restrip/operations/result.hpp"

namespace restrip::detail {

/// How often an isolated triangle is passed on.
inline constexpr int default_absorptions = 4;

/// The result of an operation and of the repair after it.
inline Rewrite with(Rewrite rewrite, const ColoringChange& repair) {
  rewrite += repair;
  return rewrite;
}

/// Absorbs the triangle to the left of h if it is isolated and a neighbour can take it. If every neighbour would have
/// to isolate another triangle, one of them does, and that triangle is absorbed in turn, `depth` times at most. If that
/// fails as well, nothing has changed. paint(h, solid) colours dual edges, and end(h) is called for each triangle that
/// has become a strip end, with one of its halfedges. Constant time.
template <class Paint, class End>
ColoringChange absorb_with(const StripMesh& mesh, Halfedge h, int depth, Paint&& paint, End&& end) {
  if (mesh.on_boundary(h) || solid_degree(mesh, h) != 0) return {};
  for (const bool pass_on : {false, true}) {
    if (pass_on && depth == 0) break;
    for (int side = 0; side < 3; ++side, h = mesh.next(h)) {
      const auto across = mesh.opposite(h);
      if (mesh.on_boundary(across)) continue;
      const unsigned degree = solid_degree(mesh, across);
      if (degree < 2) {  // the end of a strip, or isolated as well
        paint(h, true);
        end(h);
        return {-1, 0, degree == 0 ? -2 : -1};
      }
      for (auto other = mesh.next(across); !(other == across); other = mesh.next(other)) {
        if (!mesh.solid(other)) continue;
        const auto beyond = mesh.opposite(other);
        const bool spares_one = solid_degree(mesh, beyond) == 2;
        if (!spares_one && !pass_on) continue;
        paint(other, false);
        paint(h, true);
        ColoringChange done{0, 0, -1};
        if (spares_one)
          end(beyond);
        else
          done = absorb_with(mesh, beyond, depth - 1, paint, end);
        if (done.isolated < 0) {
          end(h);
          return done;
        }
        paint(h, false);
        paint(other, true);
      }
    }
  }
  return {};
}

}  // namespace restrip::detail
