// Walks over a mesh, for programs that keep more than colours: the triangles that an operation touches and their
// neighbours, on any mesh that numbers its triangles; the halfedges that leave a vertex, on a StripMesh. The single
// steps (turn_ccw, turn_cw, fan_step, strip_step) are in mesh.hpp and work on every mesh.
#pragma once

#include <cstddef>
#include <vector>

#include "restrip/mesh/mesh.hpp"
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

/// Calls visit(neighbour) for every triangle that shares an edge with t; twice if it shares two edges.
template <NumberedMesh Mesh, class Visit>
void for_each_neighbor(const Mesh& mesh, Triangle t, Visit&& visit) {
  auto h = mesh.halfedge(t);
  for (int side = 0; side < 3; ++side, h = mesh.next(h))
    if (const auto there = mesh.opposite(h); !mesh.on_boundary(there))
      visit(static_cast<Triangle>(mesh.triangle(there)));
}

/// Number of connected components of the dual graph: no colouring has fewer strips. Linear time.
template <NumberedMesh Mesh>
[[nodiscard]] std::size_t connected_components(const Mesh& mesh) {
  std::vector<bool> met(mesh.triangle_bound(), false);
  std::vector<Triangle> open;
  std::size_t components = 0;
  for (Triangle start = 0; start < mesh.triangle_bound(); ++start) {
    if (!mesh.has_triangle(start) || met[start]) continue;
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

/// The number of halfedges that leave a manifold vertex. Linear time.
[[nodiscard]] inline std::size_t spoke_count(const StripMesh& mesh, Vertex v) {
  std::size_t n = 0;
  for_each_spoke(mesh, v, [&n](StripMesh::Halfedge) { ++n; });
  return n;
}

namespace detail {

/// Adds the triangles of the vertex that h leaves, except `skip` and `skip_too`.
template <NumberedMesh Mesh>
void add_fan(const Mesh& mesh, typename Mesh::Halfedge h, std::vector<Triangle>& patch, Triangle skip = none,
             Triangle skip_too = none) {
  for_each_around(mesh, h, [&](typename Mesh::Halfedge g) {
    const auto t = static_cast<Triangle>(mesh.triangle(g));
    if (t != skip && t != skip_too) patch.push_back(t);
  });
}

}  // namespace detail

/// Sets `patch` to the triangles around the vertex that h leaves, each once: the patch before a split and after a
/// collapse. Linear in them; may throw what the vector throws.
template <NumberedMesh Mesh>
void fan_triangles(const Mesh& mesh, typename Mesh::Halfedge h, std::vector<Triangle>& patch) {
  patch.clear();
  detail::add_fan(mesh, h, patch);
}

/// Sets `patch` to the triangles around both ends of an edge, each once: the patch after a split and before a collapse.
/// Linear in them; may throw what the vector throws.
template <NumberedMesh Mesh>
void edge_triangles(const Mesh& mesh, typename Mesh::Halfedge chord, std::vector<Triangle>& patch) {
  const auto back = mesh.opposite(chord);
  const Triangle left = mesh.on_boundary(chord) ? none : static_cast<Triangle>(mesh.triangle(chord));
  const Triangle right = mesh.on_boundary(back) ? none : static_cast<Triangle>(mesh.triangle(back));
  patch.clear();
  detail::add_fan(mesh, chord, patch);
  detail::add_fan(mesh, back, patch, left, right);
}

/// Appends the neighbours of the triangles in `patch`, then theirs, and so on: `rings` times. Many triangles come more
/// than once. May throw what the vector throws.
template <NumberedMesh Mesh>
void add_rings(const Mesh& mesh, std::vector<Triangle>& patch, unsigned rings) {
  for (std::size_t i = 0; rings > 0; --rings)
    for (const std::size_t end = patch.size(); i < end; ++i)
      for_each_neighbor(mesh, patch[i], [&](Triangle t) { patch.push_back(t); });
}

}  // namespace restrip
