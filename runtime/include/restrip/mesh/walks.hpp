// Walks over a mesh, for programs that keep more than colours: the triangles that an operation touches and their
// neighbours; the halfedges that leave a vertex.
#pragma once

#include <cstddef>
#include <vector>

#include "restrip/mesh/strip_mesh.hpp"

namespace restrip {

/// The next halfedge that leaves the same vertex, turning counter-clockwise. Needs a triangle to the left of h.
[[nodiscard]] inline Halfedge turn_ccw(const StripMesh& mesh, Halfedge h) {
  return mesh.opposite(mesh.next(mesh.next(h)));
}

/// The next halfedge that leaves the same vertex, turning clockwise. Needs a triangle to the right of h.
[[nodiscard]] inline Halfedge turn_cw(const StripMesh& mesh, Halfedge h) { return mesh.next(mesh.opposite(h)); }

/// Calls visit(spoke) for each triangle around the vertex that h leaves, with its halfedge that leaves the vertex:
/// counter-clockwise from h, then, if the fan is open, clockwise from h.
template <class Visit>
void for_each_around(const StripMesh& mesh, Halfedge h, Visit&& visit) {
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

/// Calls visit(spoke) for every halfedge that leaves a manifold vertex, boundary spokes included.
template <class Visit>
void for_each_spoke(const StripMesh& mesh, Vertex v, Visit&& visit) {
  const Halfedge first = mesh.spoke(v);
  Halfedge h = first;
  do {
    visit(h);
    if (StripMesh::on_boundary(h)) return;
    h = turn_ccw(mesh, h);
  } while (!(h == first));
}

/// Calls visit(neighbour) for every triangle that shares an edge with t; twice if it shares two edges.
template <class Visit>
void for_each_neighbor(const StripMesh& mesh, Triangle t, Visit&& visit) {
  auto h = mesh.halfedge(t);
  for (int side = 0; side < 3; ++side, h = mesh.next(h))
    if (const auto there = mesh.opposite(h); !mesh.on_boundary(there)) visit(StripMesh::triangle(there));
}

/// Number of connected components of the dual graph: no colouring has fewer strips. Linear time.
[[nodiscard]] std::size_t connected_components(const StripMesh& mesh);

/// The number of halfedges that leave a manifold vertex. Linear time.
[[nodiscard]] std::size_t spoke_count(const StripMesh& mesh, Vertex v);

/// Sets `patch` to the triangles around the vertex that h leaves, each once: the patch before a split and after a
/// collapse. Linear in them; may throw what the vector throws.
void fan_triangles(const StripMesh& mesh, Halfedge h, std::vector<Triangle>& patch);

/// Sets `patch` to the triangles around both ends of an edge, each once: the patch after a split and before a collapse.
/// Linear in them; may throw what the vector throws.
void edge_triangles(const StripMesh& mesh, Halfedge chord, std::vector<Triangle>& patch);

/// Appends the neighbours of the triangles in `patch`, then theirs, and so on: `rings` times. Many triangles come more
/// than once. May throw what the vector throws.
void add_rings(const StripMesh& mesh, std::vector<Triangle>& patch, unsigned rings);

}  // namespace restrip
