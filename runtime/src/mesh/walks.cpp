// Lists of triangles around an operation, and connected components.
#include "restrip/mesh/walks.hpp"

#include <cstddef>
#include <vector>

namespace restrip {

std::size_t connected_components(const StripMesh& mesh) {
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

std::size_t spoke_count(const StripMesh& mesh, Vertex v) {
  std::size_t n = 0;
  for_each_spoke(mesh, v, [&n](Halfedge) { ++n; });
  return n;
}

// Adds the triangles of the vertex that h leaves, except `skip` and `skip_too`.
static void add_fan(const StripMesh& mesh, Halfedge h, std::vector<Triangle>& patch, Triangle skip = none,
                    Triangle skip_too = none) {
  for_each_around(mesh, h, [&](Halfedge g) {
    const auto t = StripMesh::triangle(g);
    if (t != skip && t != skip_too) patch.push_back(t);
  });
}

void fan_triangles(const StripMesh& mesh, Halfedge h, std::vector<Triangle>& patch) {
  patch.clear();
  add_fan(mesh, h, patch);
}

void edge_triangles(const StripMesh& mesh, Halfedge chord, std::vector<Triangle>& patch) {
  const auto back = mesh.opposite(chord);
  const Triangle left = mesh.on_boundary(chord) ? none : static_cast<Triangle>(mesh.triangle(chord));
  const Triangle right = mesh.on_boundary(back) ? none : static_cast<Triangle>(mesh.triangle(back));
  patch.clear();
  add_fan(mesh, chord, patch);
  add_fan(mesh, back, patch, left, right);
}

void add_rings(const StripMesh& mesh, std::vector<Triangle>& patch, unsigned rings) {
  for (std::size_t i = 0; rings > 0; --rings)
    for (const std::size_t end = patch.size(); i < end; ++i)
      for_each_neighbor(mesh, patch[i], [&](Triangle t) { patch.push_back(t); });
}

}  // namespace restrip
