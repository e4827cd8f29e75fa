// Parts of the checks that several sources share.
#pragma once

#include <cstddef>

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

}  // namespace restrip::detail
