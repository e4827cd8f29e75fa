// The triangles of a patch, for those who keep more than colours: around the vertices of an operation, each once.
#pragma once

#include <vector>

#include "restrip/strip_mesh.hpp"

namespace restrip::detail {

/// Adds the triangles of the vertex that h leaves, but `skip` and `skip_too`.
inline void add_fan(const StripMesh& mesh, StripMesh::Halfedge h, std::vector<Triangle>& patch, Triangle skip = none,
                    Triangle skip_too = none) {
  const auto add = [&](StripMesh::Halfedge g) {
    const Triangle t = StripMesh::triangle(g);
    if (t != skip && t != skip_too) patch.push_back(t);
  };
  StripMesh::Halfedge g = h;
  while (!StripMesh::on_boundary(g)) {
    add(g);
    g = mesh.fan_step(g).spoke;
    if (g == h) return;
  }
  for (g = h; !StripMesh::on_boundary(mesh.opposite(g));) {
    g = turn_cw(mesh, g);
    add(g);
  }
}

/// The triangles around the vertex that h leaves: the patch before a split and after a collapse.
inline void fan_triangles(const StripMesh& mesh, StripMesh::Halfedge h, std::vector<Triangle>& patch) {
  patch.clear();
  add_fan(mesh, h, patch);
}

/// The triangles around both ends of an edge: the patch after a split and before a collapse.
inline void edge_triangles(const StripMesh& mesh, StripMesh::Halfedge chord, std::vector<Triangle>& patch) {
  const StripMesh::Halfedge back = mesh.opposite(chord);
  const Triangle left = StripMesh::on_boundary(chord) ? none : StripMesh::triangle(chord);
  const Triangle right = StripMesh::on_boundary(back) ? none : StripMesh::triangle(back);
  patch.clear();
  add_fan(mesh, chord, patch);
  add_fan(mesh, back, patch, left, right);
}

}  // namespace restrip::detail
