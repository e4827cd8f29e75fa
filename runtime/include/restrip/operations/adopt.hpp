// Adoption: a triangle that an operation left isolated is taken into the strip of a neighbour that can spare an end.
//
// Splits and collapses inside the mesh never add an isolated triangle (proved for fans of up to eight triangles, tested
// for larger ones). On its boundary, and in flips, even the optimal rule sometimes must, because it reads and writes
// only its patch. Looking one triangle further helps: the isolated triangle x takes the edge to a neighbour t, and t
// gives up one of its two solid edges, to a triangle that has another one. The number of strips stays the same, no
// other triangle becomes isolated, and no cycle can close, because x had no solid edge.
//
// Call after an operation whose Rewrite says `isolated > 0`, or after any flip. Adoption writes colours outside the
// patch, so operations that adopt do not commute with their neighbours. Constant time a triangle, and rarely needed.
#pragma once

#include "restrip/mesh/mesh.hpp"
#include "restrip/operations/operations.hpp"

namespace restrip {

/// What a repair after an operation changed.
struct Mending {
  int strips = 0;    ///< change in the number of strips: 0 or less
  int isolated = 0;  ///< change in the number of isolated triangles: 0 or less

  constexpr Mending& operator+=(Mending more) noexcept {
    strips += more.strips;
    isolated += more.isolated;
    return *this;
  }
};

namespace detail {

/// Solid dual edges of the triangle to the left of h.
template <class Mesh>
int solid_degree(const Mesh& mesh, typename Mesh::Halfedge h) {
  if constexpr (requires { mesh.solid_degree(mesh.triangle(h)); })
    return static_cast<int>(mesh.solid_degree(mesh.triangle(h)));
  const auto second = mesh.next(h);
  return int{mesh.solid(h)} + int{mesh.solid(second)} + int{mesh.solid(mesh.next(second))};
}

}  // namespace detail

namespace detail {

/// adopt() for callers that keep more than colours: paint(h, solid) colours dual edges.
template <class Mesh, class Paint>
Mending adopt_with(const Mesh& mesh, typename Mesh::Halfedge h, int depth, Paint&& paint) {
  if (mesh.on_boundary(h) || solid_degree(mesh, h) != 0) return {};
  for (const bool pass_on : {false, true}) {
    if (pass_on && depth == 0) break;
    for (int side = 0; side < 3; ++side, h = mesh.next(h)) {
      const auto across = mesh.opposite(h);
      if (mesh.on_boundary(across)) continue;
      const int degree = solid_degree(mesh, across);
      if (degree < 2) {  // the end of a strip, or isolated as well
        paint(h, true);
        return {-1, degree == 0 ? -2 : -1};
      }
      for (auto other = mesh.next(across); !(other == across); other = mesh.next(other)) {
        if (!mesh.solid(other)) continue;
        const auto beyond = mesh.opposite(other);
        const bool spares_one = solid_degree(mesh, beyond) == 2;
        if (!spares_one && !pass_on) continue;
        paint(other, false);
        paint(h, true);
        if (spares_one) return {0, -1};
        if (const Mending next = adopt_with(mesh, beyond, depth - 1, paint); next.isolated < 0) return next;
        paint(h, false);
        paint(other, true);
      }
    }
  }
  return {};
}

}  // namespace detail

/// Adopts the triangle to the left of h if it is isolated and a neighbour can take it. If every neighbour would have to
/// isolate another triangle, one of them does, and that triangle is adopted in turn, `depth` times at most. If that
/// fails as well, nothing has changed.
template <ColoredMesh Mesh>
Mending adopt(Mesh& mesh, typename Mesh::Halfedge h, int depth = 4) {
  RESTRIP_ASSERT(detail::knows(mesh, h), "adopt", describe(Refusal::no_such_edge));
  return detail::adopt_with(mesh, h, depth, [&mesh](auto g, bool solid) { mesh.set_solid(g, solid); });
}

namespace detail {

/// Calls `mend` with a halfedge of each triangle around the vertex that h leaves, and adds up its results.
template <class Mesh, class Mend>
Mending mend_around(const Mesh& mesh, typename Mesh::Halfedge h, Mend&& mend) {
  Mending sum;
  auto g = h;
  while (!mesh.on_boundary(g)) {
    sum += mend(g);
    g = turn_ccw(mesh, g);
    if (g == h) return sum;
  }
  for (g = h; !mesh.on_boundary(mesh.opposite(g));) {
    g = turn_cw(mesh, g);
    sum += mend(g);
  }
  return sum;
}

}  // namespace detail

/// Adopts the isolated triangles around the vertex that h leaves: after a split (h the chord) or a collapse (h the
/// spoke).
template <ColoredMesh Mesh>
Mending adopt_around(Mesh& mesh, typename Mesh::Halfedge h) {
  RESTRIP_ASSERT(detail::knows(mesh, h), "adopt_around", describe(Refusal::no_such_edge));
  return detail::mend_around(mesh, h, [&](typename Mesh::Halfedge g) { return adopt(mesh, g); });
}

/// Adopts what a flip isolated: its two triangles and the four around them. h is the turned edge.
template <ColoredMesh Mesh>
Mending adopt_after_flip(Mesh& mesh, typename Mesh::Halfedge h) {
  RESTRIP_ASSERT(detail::knows(mesh, h), "adopt_after_flip", describe(Refusal::no_such_edge));
  Mending sum;
  for (const auto inner : {h, mesh.opposite(h)}) {
    if (mesh.on_boundary(inner)) continue;
    const auto second = mesh.next(inner);
    for (const auto g : {inner, mesh.opposite(second), mesh.opposite(mesh.next(second))}) sum += adopt(mesh, g);
  }
  return sum;
}

namespace detail {

template <class Halfedge>
Rewrite<Halfedge> with(Rewrite<Halfedge> rewrite, Mending mending) {
  rewrite.strips += mending.strips;
  rewrite.isolated += mending.isolated;
  return rewrite;
}

}  // namespace detail

/// split(), then adoption if the rule isolated a triangle. The Rewrite counts both.
template <SplittableMesh Mesh, class... Name>
Rewrite<typename Mesh::Halfedge> split_and_adopt(Mesh& mesh, const VertexSplit<typename Mesh::Halfedge>& where,
                                                 Name... name) {
  RESTRIP_ASSERT(detail::refusal_of_split(mesh, where, name...) == Refusal::granted, "split_and_adopt",
                 describe(detail::refusal_of_split(mesh, where, name...)));
  const auto done = split(mesh, where, name...);
  return done.isolated > 0 ? detail::with(done, adopt_around(mesh, done.halfedge)) : done;
}

/// collapse(), then adoption if the rule isolated a triangle.
template <CollapsibleMesh Mesh>
Rewrite<typename Mesh::Halfedge> collapse_and_adopt(Mesh& mesh, typename Mesh::Halfedge chord) {
  RESTRIP_ASSERT(detail::refusal_of_collapse(mesh, chord) == Refusal::granted, "collapse_and_adopt",
                 describe(detail::refusal_of_collapse(mesh, chord)));
  const auto done = collapse(mesh, chord);
  return done.isolated > 0 ? detail::with(done, adopt_around(mesh, done.halfedge)) : done;
}

/// flip(), then adoption. The Rewrite counts both.
template <FlippableMesh Mesh>
Rewrite<typename Mesh::Halfedge> flip_and_adopt(Mesh& mesh, typename Mesh::Halfedge h) {
  RESTRIP_ASSERT(detail::refusal_of_flip(mesh, h) == Refusal::granted, "flip_and_adopt",
                 describe(detail::refusal_of_flip(mesh, h)));
  const auto done = flip(mesh, h);
  return detail::with(done, adopt_after_flip(mesh, done.halfedge));
}

}  // namespace restrip
