// Valid colourings at random.
#pragma once

#include <algorithm>
#include <random>
#include <vector>

#include "restrip/mesh/strip_mesh.hpp"

namespace restrip {

// Colours dual edges solid in random order wherever that keeps the colouring valid, with the given probability.
inline void color_at_random(StripMesh& mesh, double share, std::mt19937& random) {
  std::vector<StripMesh::Halfedge> edges;
  for (Triangle t = 0; t < mesh.triangle_bound(); ++t)
    for (unsigned s = 0; s < 3; ++s)
      if (mesh.alive(t) && !StripMesh::on_boundary(mesh.opposite(StripMesh::halfedge(t, s))))
        edges.push_back(StripMesh::halfedge(t, s));
  std::shuffle(edges.begin(), edges.end(), random);
  std::vector<Triangle> component(mesh.triangle_bound());
  for (Triangle t = 0; t < component.size(); ++t) component[t] = t;
  for (const StripMesh::Halfedge h : edges) {
    const Triangle a = StripMesh::triangle(h);
    const Triangle b = StripMesh::triangle(mesh.opposite(h));
    if (mesh.solid_degree(a) > 1 || mesh.solid_degree(b) > 1 || component[a] == component[b]) continue;
    if (std::uniform_real_distribution<>()(random) > share) continue;
    mesh.set_solid(h, true);
    const Triangle from = component[a];
    for (Triangle& c : component)
      if (c == from) c = component[b];
  }
}

}  // namespace restrip
