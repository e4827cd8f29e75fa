// Preconditions of split, collapse and flip on a StripMesh: whether an operation is legal, and if not, why.
//
// A check changes nothing. An operation is granted exactly when all of this holds:
//  - its halfedges belong to the mesh, and its vertices v_h, v_s, v_t, v_l, v_r are manifold (StripMesh::non_manifold),
//    except the new one, which is not part of a triangle yet;
//  - closed fans that are split have three triangles or more;
//  - the mesh keeps its properties: no edge of three triangles, no new non-manifold vertex, three triangles or more at
//    every interior vertex of the operation, no vertex lost except the one that a collapse removes, the same topology.
//
// In debug builds (precondition.hpp) operations call these and abort on a refusal; with NDEBUG they check nothing. For
// operations from an untrusted source call these first, or checked_split() and its siblings (checked.hpp).
#pragma once

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <vector>

#include "restrip/mesh/refusal.hpp"
#include "restrip/mesh/strip_mesh.hpp"
#include "restrip/mesh/walks.hpp"

namespace restrip {

namespace detail {

/// The number of spokes of v, or `most` if there are more. O(most), for any size of the fan.
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

/// Whether at least three triangles remain around the vertex that h leaves when `fewer` are removed, or the vertex is
/// on the boundary. Constant time.
inline bool keeps_enough(const StripMesh& mesh, StripMesh::Halfedge h, std::size_t fewer) {
  return mesh.leaves_boundary(h) || spokes_up_to(mesh, mesh.from(h), 3 + fewer) == 3 + fewer;
}

/// Whether a vertex other than v_l and v_r is a neighbour of both v_s and v_t. O(sum of their valences); if both exceed
/// `few`, times the logarithm of the smaller one, and then it allocates.
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

/// Whether a new vertex may have this name, or `none`. O(1).
[[nodiscard]] inline Refusal refusal_of_name(const StripMesh& mesh, Vertex name) {
  if (name == none) return Refusal::granted;
  if (name < mesh.vertex_bound()) return mesh.spoke(name).id != none ? Refusal::vertex_in_use : Refusal::granted;
  const std::size_t gap = name - mesh.vertex_bound();
  return gap > StripMesh::max_vertex_gap + mesh.triangle_bound() ? Refusal::vertex_too_far : Refusal::granted;
}

}  // namespace detail

/// Whether the vertex may be split there. `new_vertex`: the name of the new vertex, or `none` for the next free one.
/// O(1).
[[nodiscard]] inline Refusal check_split(const StripMesh& mesh, const VertexSplit<StripMesh::Halfedge>& where,
                                         Vertex new_vertex = none) {
  using Spokes = VertexSplit<StripMesh::Halfedge>::Spokes;
  const bool has_left = where.spokes != Spokes::right_only;
  const bool has_right = where.spokes != Spokes::left_only;
  if ((has_left && !mesh.alive(where.left)) || (has_right && !mesh.alive(where.right))) return Refusal::no_such_edge;
  const StripMesh::Halfedge first = has_left ? where.left : where.right;
  if (has_left && has_right) {
    if (mesh.from(where.left) != mesh.from(where.right)) return Refusal::different_vertices;
    if (where.left == where.right) return Refusal::same_spoke;
  }
  if (mesh.non_manifold(mesh.from(first)) || (has_left && mesh.non_manifold(mesh.to(where.left))) ||
      (has_right && mesh.non_manifold(mesh.to(where.right))))
    return Refusal::non_manifold_vertex;
  if (!(has_left && has_right) && !mesh.leaves_boundary(first)) return Refusal::spoke_on_boundary;
  if (!detail::keeps_enough(mesh, first, 0)) return Refusal::too_few_triangles;
  return detail::refusal_of_name(mesh, new_vertex);
}

namespace detail {

/// check_collapse for callers with a custom test whether a vertex other than v_l and v_r is a neighbour of both v_s and
/// v_t: shared(v_s, v_t, v_l, v_r). It is called last; everything else takes constant time.
template <class Shared>
[[nodiscard]] Refusal check_collapse_with(const StripMesh& mesh, StripMesh::Halfedge chord, Shared&& shared) {
  if (!mesh.alive(chord)) return Refusal::no_such_edge;
  const StripMesh::Halfedge back = mesh.opposite(chord);
  const Vertex v_s = mesh.from(chord);
  const Vertex v_t = mesh.to(chord);
  if (mesh.non_manifold(v_s) || mesh.non_manifold(v_t)) return Refusal::non_manifold_vertex;
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
    if (mesh.non_manifold(*apex)) return Refusal::non_manifold_vertex;
    if (!keeps_enough(mesh, down, 1)) return Refusal::too_few_triangles;
  }
  // The fan has three triangles or more: in the only other case, a tetrahedron, the apexes have too few.
  return shared(v_s, v_t, v_l, v_r) ? Refusal::link_condition : Refusal::granted;
}

}  // namespace detail

/// Whether the edge of `chord` may be collapsed (link condition: Dey, Edelsbrunner, Guha, Nekhayev 1999). A few steps
/// on ordinary meshes; at worst O(n log n) for n = the sum of the valences of its two ends. Allocates only if both
/// exceed 32.
[[nodiscard]] inline Refusal check_collapse(const StripMesh& mesh, StripMesh::Halfedge chord) {
  return detail::check_collapse_with(mesh, chord, [&mesh](Vertex v_s, Vertex v_t, Vertex v_l, Vertex v_r) {
    return detail::share_neighbor(mesh, v_s, v_t, v_l, v_r);
  });
}

/// Whether the edge of h may be flipped. O(valence).
[[nodiscard]] inline Refusal check_flip(const StripMesh& mesh, StripMesh::Halfedge h) {
  if (!mesh.alive(h)) return Refusal::no_such_edge;
  const StripMesh::Halfedge back = mesh.opposite(h);
  if (StripMesh::on_boundary(h) || StripMesh::on_boundary(back)) return Refusal::boundary_edge;
  const Vertex l = mesh.to(StripMesh::next(h));
  const Vertex r = mesh.to(StripMesh::next(back));
  for (const Vertex v : {mesh.from(h), mesh.to(h), l, r})
    if (mesh.non_manifold(v)) return Refusal::non_manifold_vertex;
  // The ends of the edge keep enough triangles: if one has three, l and r are neighbours; if it has two, l is r.
  return l == r || mesh.spoke(l, r).id != none ? Refusal::edge_exists : Refusal::granted;
}

}  // namespace restrip

#include "restrip/mesh/impl/replace.hpp"
