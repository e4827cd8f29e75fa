// Walks around the vertices of a StripMesh, for programs that keep more than colours: which halfedges leave a vertex,
// and which triangles an operation touches. The single steps (turn_ccw, turn_cw, fan_step, strip_step) are in mesh.hpp
// and work on every mesh.
#pragma once

#include <cstddef>
#include <vector>

#include "restrip/mesh/strip_mesh.hpp"

namespace restrip {

/// Calls visit(spoke) for every halfedge that leaves a manifold vertex, boundary spokes included.
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

/// Calls visit(neighbour) for every triangle that shares an edge with t; twice where it shares two edges.
template <class Visit>
void for_each_neighbor(const StripMesh& mesh, Triangle t, Visit&& visit) {
  for (unsigned s = 0; s < 3; ++s)
    if (const StripMesh::Halfedge there = mesh.opposite(StripMesh::halfedge(t, s)); !StripMesh::on_boundary(there))
      visit(StripMesh::triangle(there));
}

/// Number of connected components of the dual graph: no colouring has fewer strips. Linear time.
[[nodiscard]] inline std::size_t connected_components(const StripMesh& mesh) {
  std::vector<bool> met(mesh.triangle_bound(), false);
  std::vector<Triangle> open;
  std::size_t components = 0;
  for (Triangle start = 0; start < mesh.triangle_bound(); ++start) {
    if (!mesh.alive(start) || met[start]) continue;
    ++components;
    met[start] = true;
    open.push_back(start);
    while (!open.empty()) {
      const Triangle t = open.back();
      open.pop_back();
      for_each_neighbor(mesh, t, [&](Triangle u) {
        if (!met[u]) open.push_back(u);
        met[u] = true;
      });
    }
  }
  return components;
}

/// The number of halfedges that leave a manifold vertex. Linear in it.
[[nodiscard]] inline std::size_t spoke_count(const StripMesh& mesh, Vertex v) {
  std::size_t n = 0;
  for_each_spoke(mesh, v, [&n](StripMesh::Halfedge) { ++n; });
  return n;
}

namespace detail {

/// Adds the triangles of the vertex that h leaves, except `skip` and `skip_too`.
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

}  // namespace detail

/// Sets `patch` to the triangles around the vertex that h leaves, each once: the patch before a split and after a
/// collapse. Linear in them; may throw what the vector throws.
inline void fan_triangles(const StripMesh& mesh, StripMesh::Halfedge h, std::vector<Triangle>& patch) {
  patch.clear();
  detail::add_fan(mesh, h, patch);
}

/// Sets `patch` to the triangles around both ends of an edge, each once: the patch after a split and before a collapse.
/// Linear in them; may throw what the vector throws.
inline void edge_triangles(const StripMesh& mesh, StripMesh::Halfedge chord, std::vector<Triangle>& patch) {
  const StripMesh::Halfedge back = mesh.opposite(chord);
  const Triangle left = StripMesh::on_boundary(chord) ? none : StripMesh::triangle(chord);
  const Triangle right = StripMesh::on_boundary(back) ? none : StripMesh::triangle(back);
  patch.clear();
  detail::add_fan(mesh, chord, patch);
  detail::add_fan(mesh, back, patch, left, right);
}

/// Appends the neighbours of the triangles in `patch`, then theirs, and so on: `rings` times. Many triangles come more
/// than once. May throw what the vector throws.
inline void add_rings(const StripMesh& mesh, std::vector<Triangle>& patch, unsigned rings) {
  for (std::size_t i = 0; rings > 0; --rings)
    for (const std::size_t end = patch.size(); i < end; ++i)
      for_each_neighbor(mesh, patch[i], [&](Triangle t) { patch.push_back(t); });
}

}  // namespace restrip
