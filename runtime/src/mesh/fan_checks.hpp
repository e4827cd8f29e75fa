// Parts of the checks that several sources share.
#pragma once

#include <cstddef>
#include <tuple>

#include "restrip/mesh/refusal.hpp"
#include "restrip/mesh/strip_mesh.hpp"
#include "restrip/mesh/walks.hpp"

namespace restrip::detail {

/// The number of spokes of v, or `most` if there are more. O(most), for any size of the fan.
inline std::size_t spokes_up_to(const StripMesh& mesh, Vertex v, std::size_t most) {
  const Halfedge first = mesh.spoke(v);
  Halfedge h = first;
  for (std::size_t n = 1; n < most; ++n) {
    if (StripMesh::on_boundary(h)) return n;
    h = turn_ccw(mesh, h);
    if (h == first) return n;
  }
  return most;
}

/// Whether at least three triangles remain around the vertex that h leaves when `fewer` are removed, or the vertex is
/// on the boundary. Constant time.
inline bool keeps_enough(const StripMesh& mesh, Halfedge h, std::size_t fewer) {
  return mesh.leaves_boundary(h) || spokes_up_to(mesh, mesh.from(h), 3 + fewer) == 3 + fewer;
}

/// Whether a new vertex may have this name, or `none`. O(1).
[[nodiscard]] inline Refusal refusal_of_name(const StripMesh& mesh, Vertex name) {
  if (name == none) return Refusal::granted;
  if (name < mesh.vertex_bound()) return mesh.spoke(name).id != none ? Refusal::vertex_in_use : Refusal::granted;
  const std::size_t gap = name - mesh.vertex_bound();
  return gap > StripMesh::max_vertex_gap + mesh.triangle_bound() ? Refusal::vertex_too_far : Refusal::granted;
}

/// check_collapse for callers with a custom test whether a vertex other than v_l and v_r is a neighbour of both v_s and
/// v_t: shared(v_s, v_t, v_l, v_r). It is called last; everything else takes constant time.
template <class Shared>
[[nodiscard]] Refusal check_collapse_with(const StripMesh& mesh, Halfedge chord, Shared&& shared) {
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
    if (!keeps_enough(mesh, down, 1)) return Refusal::too_few_triangles;
  }
  // The fan has three triangles or more: in the only other case, a tetrahedron, the apexes have too few.
  return shared(v_s, v_t, v_l, v_r) ? Refusal::link_condition : Refusal::granted;
}

}  // namespace restrip::detail
