// The walks visit exactly what a scan of all triangles finds: of a vertex, of both ends of an edge, of the neighbours,
// of the component.
#include "restrip/mesh/walks.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <set>
#include <utility>
#include <vector>

#include "naive_patch.hpp"
#include "sample_meshes.hpp"

namespace restrip {
namespace {

using Halfedge = StripMesh::Halfedge;

/// The triangles that have one of these corners.
std::vector<Triangle> triangles_around(const StripMesh& mesh, const std::vector<Vertex>& vertices) {
  std::vector<Triangle> found;
  for (Triangle t = 0; t < mesh.triangle_bound(); ++t) {
    const auto corners = mesh.corners(t);
    if (std::find_first_of(corners.begin(), corners.end(), vertices.begin(), vertices.end()) != corners.end())
      found.push_back(t);
  }
  return found;
}

std::vector<Triangle> in_order(std::vector<Triangle> triangles) {
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

/// Pairs of triangles that share an edge, once for each edge that they share, in both orders.
std::vector<std::pair<Triangle, Triangle>> neighbors(const StripMesh& mesh) {
  std::vector<std::pair<Triangle, Triangle>> pairs;
  for (Triangle t = 0; t < mesh.triangle_bound(); ++t)
    for (Triangle u = 0; u < mesh.triangle_bound(); ++u)
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
          if (t != u && mesh.corners(t)[i] == mesh.corners(u)[(j + 1) % 3] &&
              mesh.corners(t)[(i + 1) % 3] == mesh.corners(u)[j])
            pairs.emplace_back(t, u);
  return pairs;
}

TEST(Walks, VisitWhatALookThroughAllTrianglesFinds) {
  for (const StripMesh& mesh : sample::manifold_meshes()) {
    std::vector<Triangle> patch;
    for (const Halfedge h : sample::sides_of(mesh)) {
      for (const Halfedge chord : {h, mesh.opposite(h)}) {
        edge_triangles(mesh, chord, patch);
        EXPECT_EQ(in_order(patch), triangles_around(mesh, {mesh.from(h), mesh.to(h)}));
      }
      fan_triangles(mesh, h, patch);
      const std::vector<Triangle> around = triangles_around(mesh, {mesh.from(h)});
      EXPECT_EQ(in_order(patch), around);
      // One more spoke than triangles where the fan is open.
      std::set<Vertex> ends;
      for_each_spoke(mesh, mesh.from(h), [&](Halfedge spoke) {
        EXPECT_EQ(mesh.from(spoke), mesh.from(h));
        ends.insert(mesh.to(spoke));
      });
      EXPECT_EQ(spoke_count(mesh, mesh.from(h)), around.size() + (mesh.leaves_boundary(h) ? 1U : 0U));
      EXPECT_LE(ends.size(), spoke_count(mesh, mesh.from(h)));
      for (const Triangle u : around)
        for (const Vertex v : mesh.corners(u)) EXPECT_TRUE(v == mesh.from(h) || ends.contains(v));
    }
  }
}

TEST(Walks, RingsAndComponentsFollowFromPairsOfNeighbors) {
  for (const StripMesh& mesh : sample::manifold_meshes()) {
    const auto pairs = neighbors(mesh);
    naive::UnionFind components(mesh.triangle_bound());
    std::size_t count = mesh.triangle_count();
    for (const auto& [t, u] : pairs) count -= components.unite(t, u) ? 1U : 0U;
    EXPECT_EQ(connected_components(mesh), count);
    std::set<Triangle> reached{0};
    for (unsigned rings = 0; rings < 4; ++rings) {
      std::vector<Triangle> patch{0};
      add_rings(mesh, patch, rings);
      EXPECT_EQ(std::set<Triangle>(patch.begin(), patch.end()), reached) << rings << " rings";
      const std::set<Triangle> before = reached;
      for (const auto& [t, u] : pairs)
        if (before.contains(t)) reached.insert(u);
    }
    for (Triangle t = 0; t < mesh.triangle_bound(); ++t) {
      std::vector<std::pair<Triangle, Triangle>> visited;
      for_each_neighbor(mesh, t, [&](Triangle u) { visited.emplace_back(t, u); });
      for (const auto& pair : visited)
        EXPECT_EQ(std::count(visited.begin(), visited.end(), pair), std::count(pairs.begin(), pairs.end(), pair));
      EXPECT_EQ(static_cast<long>(visited.size()),
                std::count_if(pairs.begin(), pairs.end(), [t](const auto& pair) { return pair.first == t; }));
    }
  }
}

}  // namespace
}  // namespace restrip
