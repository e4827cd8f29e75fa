// Valid colourings at random.
#pragma once

#include <algorithm>
#include <random>
#include <vector>

#include "naive_patch.hpp"
#include "sample_meshes.hpp"

namespace restrip {

// Colours the mesh again: dual edges become solid in random order wherever that keeps the colouring valid, with the
// given probability.
template <class Random>
void color_at_random(StripMesh& mesh, double share, Random& random) {
  mesh.clear_colors();
  std::vector<StripMesh::Halfedge> edges = sample::dual_edges(mesh);
  std::shuffle(edges.begin(), edges.end(), random);
  naive::UnionFind strips(mesh.triangle_bound());
  for (const StripMesh::Halfedge h : edges) {
    const Triangle a = StripMesh::triangle(h);
    const Triangle b = StripMesh::triangle(mesh.opposite(h));
    if (mesh.solid_degree(a) > 1 || mesh.solid_degree(b) > 1 || strips.find(a) == strips.find(b)) continue;
    if (std::uniform_real_distribution<>()(random) > share) continue;
    strips.unite(a, b);
    mesh.set_solid(h, true);
  }
}

}  // namespace restrip
