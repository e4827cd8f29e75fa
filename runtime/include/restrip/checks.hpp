// Preconditions of split, collapse and flip on a StripMesh: may this operation be done, and if not, why not.
//
// A check changes nothing. Operations do not check by themselves, because a progressive mesh has been checked when it
// was made; call these for operations of unknown origin.
#pragma once

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <vector>

#include "restrip/strip_mesh.hpp"

namespace restrip {

/// Why an operation is refused.
enum class Refusal {
  granted,             ///< it may be done
  no_such_edge,        ///< the halfedge is not one of the mesh
  different_vertices,  ///< the two spokes of a split do not leave the same vertex
  same_spoke,          ///< the two spokes of a split are the same
  irregular_vertex,    ///< a vertex of the operation is one where the mesh is no manifold
                       ///< (BuildReport::irregular_vertices)
  boundary_edge,       ///< a flip needs a triangle on both sides
  spoke_on_boundary,   ///< a one-sided split needs a boundary vertex
  joins_boundaries,  ///< the edge is interior, but both its ends are on the boundary: the collapse would pinch the mesh
  link_condition,    ///< the ends of the edge have a common neighbour besides the apexes: the collapse would fold the
                     ///< mesh
  too_few_triangles,  ///< a closed fan of fewer than three triangles would remain
  dangling_edge,      ///< a triangle to be removed hangs on the others by the collapsed edge alone
  edge_exists         ///< the flipped edge is in the mesh already
};

/// One sentence for a person.
[[nodiscard]] constexpr const char* describe(Refusal refusal) noexcept {
  switch (refusal) {
    case Refusal::granted:
      return "the operation is possible";
    case Refusal::no_such_edge:
      return "the halfedge is not one of this mesh";
    case Refusal::different_vertices:
      return "the two spokes do not leave the same vertex";
    case Refusal::same_spoke:
      return "the two spokes are the same";
    case Refusal::irregular_vertex:
      return "the mesh is not a manifold at one of the vertices";
    case Refusal::boundary_edge:
      return "the edge lies on the boundary";
    case Refusal::spoke_on_boundary:
      return "a split with one spoke needs a vertex on the boundary";
    case Refusal::joins_boundaries:
      return "an interior edge between two boundary vertices: collapsing it would pinch the mesh";
    case Refusal::link_condition:
      return "the ends of the edge have another common neighbour: collapsing it would fold the mesh";
    case Refusal::too_few_triangles:
      return "fewer than three triangles would remain around a vertex";
    case Refusal::dangling_edge:
      return "a triangle beside the edge has no other neighbour: collapsing it would leave a dangling edge";
    case Refusal::edge_exists:
      return "the flipped edge exists already";
  }
  return "unknown";
}

namespace detail {

/// Calls visit(spoke) for every halfedge that leaves the vertex of a regular fan, boundary spokes included.
template <class Visit>
void for_each_spoke(const StripMesh& mesh, Vertex v, Visit&& visit) {
  const StripMesh::Halfedge first = mesh.spoke(v);
  StripMesh::Halfedge h = first;
  do {
    visit(h);
    if (StripMesh::on_boundary(h)) return;
    h = turn_ccw(mesh, h);
  } while (!(h == first));
}

inline std::size_t spokes(const StripMesh& mesh, Vertex v) {
  std::size_t n = 0;
  for_each_spoke(mesh, v, [&n](StripMesh::Halfedge) { ++n; });
  return n;
}

/// The number of spokes of v, or `most` if there are more: O(most), so that a fan of any size can be asked.
inline std::size_t spokes_up_to(const StripMesh& mesh, Vertex v, std::size_t most) {
  const StripMesh::Halfedge first = mesh.spoke(v);
  StripMesh::Halfedge h = first;
  for (std::size_t n = 1; n < most; ++n) {
    if (StripMesh::on_boundary(h)) return n;
    h = turn_ccw(mesh, h);
    if (h == first) return n;
  }
  return most;
}

/// Triangles around the vertex that h leaves stay at least three when `fewer` of them go, or the vertex is on the
/// boundary. Constant time.
inline bool keeps_enough(const StripMesh& mesh, StripMesh::Halfedge h, std::size_t fewer) {
  return mesh.leaves_boundary(h) || spokes_up_to(mesh, mesh.from(h), 3 + fewer) == 3 + fewer;
}

/// Is a vertex other than v_l and v_r a neighbour of both v_s and v_t? O(sum of their valences), times the logarithm of
/// the smaller one where both exceed `few`; only then it allocates.
inline bool share_neighbor(const StripMesh& mesh, Vertex v_s, Vertex v_t, Vertex v_l, Vertex v_r) {
  constexpr std::size_t few = 32;
  const auto other = [=](Vertex w) { return w != v_s && w != v_t && w != v_l && w != v_r; };
  bool shared = false;
  const bool s_has_few = spokes_up_to(mesh, v_s, few + 1) <= few;
  if (s_has_few || spokes_up_to(mesh, v_t, few + 1) <= few) {
    const Vertex many = s_has_few ? v_t : v_s;
    for_each_spoke(mesh, s_has_few ? v_s : v_t, [&](StripMesh::Halfedge h) {
      if (!shared && other(mesh.to(h)) && mesh.spoke(many, mesh.to(h)).id != none) shared = true;
    });
    return shared;
  }
  std::vector<Vertex> around;
  for_each_spoke(mesh, v_s, [&](StripMesh::Halfedge h) { around.push_back(mesh.to(h)); });
  std::sort(around.begin(), around.end());
  for_each_spoke(mesh, v_t, [&](StripMesh::Halfedge h) {
    if (other(mesh.to(h)) && std::binary_search(around.begin(), around.end(), mesh.to(h))) shared = true;
  });
  return shared;
}

}  // namespace detail

/// May the vertex be split there? Constant time.
[[nodiscard]] inline Refusal check_split(const StripMesh& mesh, const VertexSplit<StripMesh::Halfedge>& where) {
  using Spokes = VertexSplit<StripMesh::Halfedge>::Spokes;
  const bool both = where.spokes == Spokes::both;
  const StripMesh::Halfedge first = where.spokes == Spokes::right_only ? where.right : where.left;
  if (!mesh.alive(first) || (both && !mesh.alive(where.right))) return Refusal::no_such_edge;
  if (both && mesh.from(where.left) != mesh.from(where.right)) return Refusal::different_vertices;
  if (both && where.left == where.right) return Refusal::same_spoke;
  if (mesh.irregular(mesh.from(first))) return Refusal::irregular_vertex;
  if (!both && !mesh.leaves_boundary(first)) return Refusal::spoke_on_boundary;
  if (!mesh.leaves_boundary(first) && detail::spokes_up_to(mesh, mesh.from(first), 3) < 3)
    return Refusal::too_few_triangles;
  return Refusal::granted;
}

namespace detail {

/// check_collapse for callers with an answer of their own to "is a vertex other than v_l and v_r a neighbour of both
/// v_s and v_t?": shared(v_s, v_t, v_l, v_r). It is asked last; all the rest takes constant time.
template <class Shared>
[[nodiscard]] Refusal check_collapse_with(const StripMesh& mesh, StripMesh::Halfedge chord, Shared&& shared) {
  if (!mesh.alive(chord)) return Refusal::no_such_edge;
  const StripMesh::Halfedge back = mesh.opposite(chord);
  const Vertex v_s = mesh.from(chord);
  const Vertex v_t = mesh.to(chord);
  if (mesh.irregular(v_s) || mesh.irregular(v_t)) return Refusal::irregular_vertex;
  const bool left = !StripMesh::on_boundary(chord);
  const bool right = !StripMesh::on_boundary(back);
  const bool tail_on_boundary = mesh.leaves_boundary(chord);
  const bool head_on_boundary = mesh.leaves_boundary(back);
  if (left && right && tail_on_boundary && head_on_boundary) return Refusal::joins_boundaries;

  Vertex v_l = none;
  Vertex v_r = none;
  for (const auto& [there, inward, apex] : {std::tuple{left, chord, &v_l}, {right, back, &v_r}}) {
    if (!there) continue;
    const StripMesh::Halfedge up = StripMesh::next(inward);
    const StripMesh::Halfedge down = StripMesh::next(up);
    *apex = mesh.from(down);
    if (StripMesh::on_boundary(mesh.opposite(up)) && StripMesh::on_boundary(mesh.opposite(down)))
      return Refusal::dangling_edge;
    if (mesh.irregular(*apex)) return Refusal::irregular_vertex;
    if (!keeps_enough(mesh, down, 1)) return Refusal::too_few_triangles;
  }
  if (v_l == v_r) return Refusal::link_condition;

  constexpr std::size_t enough = 3 + 4;
  if (!tail_on_boundary && !head_on_boundary &&
      spokes_up_to(mesh, v_s, enough) + spokes_up_to(mesh, v_t, enough) < enough)
    return Refusal::too_few_triangles;
  return shared(v_s, v_t, v_l, v_r) ? Refusal::link_condition : Refusal::granted;
}

}  // namespace detail

/// May the edge of `chord` be collapsed (link condition: Dey, Edelsbrunner, Guha, Nekhayev 1999)? A few steps on
/// ordinary meshes; at worst O(n log n) for n = the sum of the valences of its two ends. Allocates only where both of
/// them exceed 32.
[[nodiscard]] inline Refusal check_collapse(const StripMesh& mesh, StripMesh::Halfedge chord) {
  return detail::check_collapse_with(mesh, chord, [&mesh](Vertex v_s, Vertex v_t, Vertex v_l, Vertex v_r) {
    return detail::share_neighbor(mesh, v_s, v_t, v_l, v_r);
  });
}

/// May the edge of h be flipped? O(valence).
[[nodiscard]] inline Refusal check_flip(const StripMesh& mesh, StripMesh::Halfedge h) {
  if (!mesh.alive(h)) return Refusal::no_such_edge;
  const StripMesh::Halfedge back = mesh.opposite(h);
  if (StripMesh::on_boundary(h) || StripMesh::on_boundary(back)) return Refusal::boundary_edge;
  const Vertex l = mesh.to(StripMesh::next(h));
  const Vertex r = mesh.to(StripMesh::next(back));
  for (const Vertex v : {mesh.from(h), mesh.to(h), l, r})
    if (mesh.irregular(v)) return Refusal::irregular_vertex;
  if (l == r || mesh.spoke(l, r).id != none) return Refusal::edge_exists;
  if (!detail::keeps_enough(mesh, h, 1) || !detail::keeps_enough(mesh, back, 1)) return Refusal::too_few_triangles;
  return Refusal::granted;
}

}  // namespace restrip
