// The checks of splits, collapses and flips.
#include "restrip/mesh/checks.hpp"

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <vector>

#include "mesh/fan_checks.hpp"
#include "restrip/mesh/walks.hpp"

namespace restrip {

namespace detail {

/// Whether a vertex other than v_l and v_r is a neighbour of both v_s and v_t. O(sum of their valences); if both exceed
/// `few`, times the logarithm of the smaller one, and then it allocates.
bool share_neighbor(const StripMesh& mesh, Vertex v_s, Vertex v_t, Vertex v_l, Vertex v_r) {
  constexpr std::size_t few = 32;
  const auto other = [=](Vertex w) { return w != v_s && w != v_t && w != v_l && w != v_r; };
  bool shared = false;
  const bool s_has_few = spokes_up_to(mesh, v_s, few + 1) <= few;
  if (s_has_few || spokes_up_to(mesh, v_t, few + 1) <= few) {
    const Vertex many = s_has_few ? v_t : v_s;
    for_each_spoke(mesh, s_has_few ? v_s : v_t, [&](Halfedge h) {
      if (!shared && other(mesh.to(h)) && mesh.spoke(many, mesh.to(h)).id != none) shared = true;
    });
    return shared;
  }
  std::vector<Vertex> around;
  for_each_spoke(mesh, v_s, [&](Halfedge h) { around.push_back(mesh.to(h)); });
  std::sort(around.begin(), around.end());
  for_each_spoke(mesh, v_t, [&](Halfedge h) {
    if (other(mesh.to(h)) && std::binary_search(around.begin(), around.end(), mesh.to(h))) shared = true;
  });
  return shared;
}

}  // namespace detail

Refusal check_split(const StripMesh& mesh, const VertexSplit& where, Vertex new_vertex) {
  using Spokes = VertexSplit::Spokes;
  const bool has_left = where.spokes != Spokes::right_only;
  const bool has_right = where.spokes != Spokes::left_only;
  if ((has_left && !mesh.alive(where.left)) || (has_right && !mesh.alive(where.right))) return Refusal::no_such_edge;
  const Halfedge first = has_left ? where.left : where.right;
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

Refusal check_collapse(const StripMesh& mesh, Halfedge chord) {
  if (!mesh.alive(chord)) return Refusal::no_such_edge;
  const Halfedge back = mesh.opposite(chord);
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
    const Halfedge up = StripMesh::next(inward);
    const Halfedge down = StripMesh::next(up);
    *apex = mesh.from(down);
    if (StripMesh::on_boundary(mesh.opposite(up)) && StripMesh::on_boundary(mesh.opposite(down)))
      return Refusal::dangling_edge;
    if (mesh.non_manifold(*apex)) return Refusal::non_manifold_vertex;
    if (!detail::keeps_enough(mesh, down, 1)) return Refusal::too_few_triangles;
  }
  // The fan has three triangles or more: in the only other case, a tetrahedron, the apexes have too few.
  return detail::share_neighbor(mesh, v_s, v_t, v_l, v_r) ? Refusal::link_condition : Refusal::granted;
}

Refusal check_flip(const StripMesh& mesh, Halfedge h) {
  if (!mesh.alive(h)) return Refusal::no_such_edge;
  const Halfedge back = mesh.opposite(h);
  if (StripMesh::on_boundary(h) || StripMesh::on_boundary(back)) return Refusal::boundary_edge;
  const Vertex l = mesh.to(StripMesh::next(h));
  const Vertex r = mesh.to(StripMesh::next(back));
  for (const Vertex v : {mesh.from(h), mesh.to(h), l, r})
    if (mesh.non_manifold(v)) return Refusal::non_manifold_vertex;
  // The ends of the edge keep enough triangles: if one has three, l and r are neighbours; if it has two, l is r.
  return l == r || mesh.spoke(l, r).id != none ? Refusal::edge_exists : Refusal::granted;
}

}  // namespace restrip
