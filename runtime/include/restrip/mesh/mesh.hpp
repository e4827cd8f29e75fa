// The interface that a mesh must have: five small functions to walk it and colour its dual edges, one more for each
// operation.
//
// You need not use StripMesh. Write an adapter with the members below around your own structure
// (adapters/openmesh.hpp and adapters/cgal.hpp are two, StripMesh models the concepts directly) and hand it to split(),
// collapse() and flip(). operations/test_adapter.hpp tests whether an adapter keeps the contract below.
//
// Exceptions. Any function of a mesh may throw, and the exception leaves the operation that called it. If the mesh
// keeps two promises, its colouring is valid after an exception, though perhaps not optimal: some dual edges may be
// dashed that could be solid. Later operations can continue from there.
//  - insert_vertex, remove_vertex and turn_edge do their work, or throw and leave the mesh and its colours as they
//    were; set_solid changes one dual edge, for both its halfedges, or none.
//  - insert_vertex leaves the dual edges of the new triangles dashed, and remove_vertex the dual edges of merged edges.
// The Rewrite is lost, so count the strips again after an exception.
// restrip first reads everything it needs, then clears edges, then changes the mesh, then sets edges. So at every
// moment the colouring is the old or the new one, perhaps with fewer solid edges.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>

#include "restrip/precondition.hpp"

namespace restrip {

/// A mesh whose dual edges carry a colour.
///
/// A *halfedge* is a directed mesh edge; its triangle lies to its left. A boundary halfedge lacks a triangle. The
/// *colour of a halfedge* is the colour of the dual edge that crosses its mesh edge: it is the same for a halfedge and
/// its opposite, and false (dashed) for a boundary edge. A mesh that knows in constant time whether the vertex that a
/// halfedge leaves is on the boundary may offer `bool leaves_boundary(h)`; otherwise restrip turns around the vertex. A
/// mesh that can check whether any given handle belongs to it may offer `bool alive(h)`; debug builds call it before
/// each operation.
template <class Mesh>
concept ColoredMesh = std::regular<typename Mesh::Halfedge> &&
    requires(const Mesh& mesh, Mesh& writable, typename Mesh::Halfedge h, bool solid) {
  /// The next halfedge around the triangle of h. Called only when h has a triangle.
  { mesh.next(h) } -> std::same_as<typename Mesh::Halfedge>;
  { mesh.opposite(h) } -> std::same_as<typename Mesh::Halfedge>;
  /// True when h lies on the boundary: it lacks a triangle.
  { mesh.on_boundary(h) } -> std::convertible_to<bool>;
  { mesh.solid(h) } -> std::convertible_to<bool>;
  /// Colours the dual edge of h (and of its opposite). Never called for a boundary edge.
  {writable.set_solid(h, solid)};
};

/// Where a vertex v_h is split: along its spokes to v_l and v_r, given as halfedges that leave v_h.
///
/// v_h stays as v_s; the new vertex v_t takes the triangles met when turning counter-clockwise from `right` to `left`.
/// With both spokes, two triangles A = (v_s, v_t, v_l) and D = (v_t, v_s, v_r) are inserted. On a boundary vertex the
/// order of the two spokes says which of the two vertices stays there. Turning counter-clockwise from one boundary edge
/// of the fan to the other,
///  - if `right` comes first, v_t takes the triangles between the spokes and is interior; v_s is on the boundary;
///  - if `left` comes first, the turn from `right` to `left` continues across the boundary: v_t takes the triangles at
///    both ends of the fan and is on the boundary; v_s keeps the triangles between the spokes and is interior.
/// Both make the same mesh except for the names. Both are needed to undo collapses of an edge with one end on the
/// boundary: the first undoes a collapse into that end, the second a collapse into the interior end.
///
/// On the boundary one spoke may be missing; then the new mesh edge is itself on the boundary, one triangle is
/// inserted, and the other spoke is ignored:
///  - left only: v_t takes the triangles clockwise of `left`, A is inserted;
///  - right only: v_t takes the triangles counter-clockwise of `right`, D is inserted.
template <class Halfedge>
struct VertexSplit {
  enum class Spokes { both, left_only, right_only };
  Halfedge left{};
  Halfedge right{};
  Spokes spokes = Spokes::both;

  /// The left spoke, or the right one if it is alone.
  [[nodiscard]] constexpr Halfedge spoke() const { return spokes == Spokes::right_only ? right : left; }
};

/// A mesh that can split a vertex: insert the triangles described at VertexSplit and return the halfedge v_s -> v_t
/// (the chord). If its only insert_vertex takes the new vertex from the caller, as a Mesh::Vertex, operations that
/// insert a vertex must be given one. Other halfedges around the vertex, except the halfedges of the two spokes, stay
/// valid handles of the same mesh edges. The dual edges of the new triangles are dashed; all others keep their colours.
template <class Mesh>
concept NamesNewVertices = ColoredMesh<Mesh> && requires(Mesh& mesh, VertexSplit<typename Mesh::Halfedge> where) {
  { mesh.insert_vertex(where) } -> std::same_as<typename Mesh::Halfedge>;
};
template <class Mesh>
concept SplittableMesh = NamesNewVertices<Mesh> ||
    (ColoredMesh<Mesh>&& requires(Mesh& mesh, VertexSplit<typename Mesh::Halfedge> where, typename Mesh::Vertex name) {
      { mesh.insert_vertex(where, name) } -> std::same_as<typename Mesh::Halfedge>;
    });

/// A mesh that can collapse the mesh edge of the halfedge v_s -> v_t: remove v_t and the triangles at the edge, and
/// return a halfedge that leaves v_s: to v_l, the apex of the triangle to the left, or if that triangle does not exist,
/// to v_r. Other halfedges around the two vertices, except the halfedges of the removed triangles and of the edges that
/// are merged, stay valid handles of the same mesh edges. The dual edges of merged edges are dashed; all others keep
/// their colours.
template <class Mesh>
concept CollapsibleMesh = ColoredMesh<Mesh> && requires(Mesh& mesh, typename Mesh::Halfedge chord) {
  { mesh.remove_vertex(chord) } -> std::same_as<typename Mesh::Halfedge>;
};

/// A mesh that can flip an interior mesh edge: the edge of u -> v, with apexes l (left) and r (right), becomes the edge
/// of r -> l, which is returned. All dual edges keep their colours.
template <class Mesh>
concept FlippableMesh = ColoredMesh<Mesh> && requires(Mesh& mesh, typename Mesh::Halfedge h) {
  { mesh.turn_edge(h) } -> std::same_as<typename Mesh::Halfedge>;
};

/// The next halfedge that leaves the same vertex, turning counter-clockwise. Needs a triangle to the left of h.
template <ColoredMesh Mesh>
[[nodiscard]] constexpr typename Mesh::Halfedge turn_ccw(const Mesh& mesh, typename Mesh::Halfedge h) {
  return mesh.opposite(mesh.next(mesh.next(h)));
}

/// The next halfedge that leaves the same vertex, turning clockwise. Needs a triangle to the right of h.
template <ColoredMesh Mesh>
[[nodiscard]] constexpr typename Mesh::Halfedge turn_cw(const Mesh& mesh, typename Mesh::Halfedge h) {
  return mesh.next(mesh.opposite(h));
}

/// Calls visit(spoke) for each triangle around the vertex that h leaves, with its halfedge that leaves the vertex:
/// counter-clockwise from h, then, if the fan is open, clockwise from h.
template <ColoredMesh Mesh, class Visit>
constexpr void for_each_around(const Mesh& mesh, typename Mesh::Halfedge h, Visit&& visit) {
  auto g = h;
  while (!mesh.on_boundary(g)) {
    visit(g);
    g = turn_ccw(mesh, g);
    if (g == h) return;
  }
  for (g = h; !mesh.on_boundary(mesh.opposite(g));) {
    g = turn_cw(mesh, g);
    visit(g);
  }
}

/// One triangle of a fan, seen from the vertex that h leaves: the colours of its port and of its dual edge to the next
/// triangle counter-clockwise, and the spoke between the two.
template <class Halfedge>
struct FanStep {
  bool port = false;
  bool edge = false;
  Halfedge spoke{};
};

/// Needs a triangle to the left of h. A mesh may offer `FanStep<Halfedge> fan_step(h)` if it can do this in one step.
template <ColoredMesh Mesh>
[[nodiscard]] constexpr FanStep<typename Mesh::Halfedge> fan_step(const Mesh& mesh, typename Mesh::Halfedge h) {
  if constexpr (requires { mesh.fan_step(h); }) return mesh.fan_step(h);
  const auto port = mesh.next(h);
  const auto edge = mesh.next(port);
  return {mesh.solid(port), mesh.solid(edge), mesh.opposite(edge)};
}

/// One triangle of a strip, entered over the dual edge of one of its halfedges: whether the strip continues, and over
/// which halfedge of the next triangle.
template <class Halfedge>
struct StripStep {
  bool continues = false;
  Halfedge in{};
};

/// A mesh may offer `StripStep<Halfedge> strip_step(in)` if it can do this without a branch for each side.
template <ColoredMesh Mesh>
[[nodiscard]] constexpr StripStep<typename Mesh::Halfedge> strip_step(const Mesh& mesh, typename Mesh::Halfedge in) {
  if constexpr (requires { mesh.strip_step(in); }) return mesh.strip_step(in);
  auto out = mesh.next(in);
  if (!mesh.solid(out)) out = mesh.next(out);
  if (!mesh.solid(out)) return {};
  return {true, mesh.opposite(out)};
}

/// A mesh that numbers its triangles and vertices. `triangle` and `from` are called only for halfedges with a triangle,
/// `halfedge` only for triangles of the mesh, `has_triangle` only for numbers below the bound.
template <class Mesh>
concept NumberedMesh = ColoredMesh<Mesh> && requires(const Mesh& mesh, typename Mesh::Halfedge h, std::uint32_t t) {
  { mesh.triangle(h) } -> std::convertible_to<std::uint32_t>;
  { mesh.halfedge(t) } -> std::same_as<typename Mesh::Halfedge>;
  { mesh.has_triangle(t) } -> std::convertible_to<bool>;
  { mesh.triangle_bound() } -> std::convertible_to<std::size_t>;
  { mesh.from(h) } -> std::convertible_to<std::uint32_t>;
};

}  // namespace restrip
