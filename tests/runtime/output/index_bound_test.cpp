// No index buffer of strips is shorter than the bound; a zigzag of triangles reaches it; and the bound is that of the
// corners, counted triangle by triangle.
#include "restrip/output/index_bound.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <map>
#include <random>
#include <vector>

#include "random_colors.hpp"
#include "restrip/output/strips.hpp"
#include "restrip/search/stripify.hpp"
#include "sample_meshes.hpp"

namespace restrip {
namespace {

TEST(IndexBound, IsReachedByAZigzagAndByNoStripsPassed) {
  for (const Vertex triangles : {1U, 2U, 3U, 10U, 101U}) {
    std::vector<sample::Corners> zigzag;
    for (Vertex t = 0; t < triangles; ++t) zigzag.push_back({t + t % 2, t + 1 - t % 2, t + 2});
    StripMesh mesh = StripMesh::build(zigzag, triangles + 2);
    EXPECT_EQ(strip_index_lower_bound(mesh), triangles + 2);
    stripify(mesh);
    EXPECT_EQ(strip_indices(mesh).size(), triangles + 2);
  }
  std::mt19937 random(6);
  for (StripMesh& mesh : sample::meshes()) {
    const std::size_t bound = strip_index_lower_bound(mesh);
    for (const double share : {0.0, 0.7, 1.0}) {
      mesh.clear_colors();
      color_at_random(mesh, share, random);
      EXPECT_GE(strip_indices(mesh).size(), bound);
    }
    stripify(mesh, Effort::best, Cost::indices());
    EXPECT_GE(strip_indices(mesh).size(), bound);
    EXPECT_EQ(strip_index_lower_bound(mesh), bound) << "whatever the colours";
  }
}

TEST(IndexBound, CountsCornersInThrees) {
  const StripMesh two_pieces = sample::meshes()[5];
  std::map<Vertex, std::size_t> corners;
  for (const sample::Corners& c : sample::triangles_of(two_pieces))
    for (const Vertex v : c) ++corners[v];
  std::size_t least = 1;  // a restart
  for (const auto& [v, n] : corners) least += n / 3 + (n % 3 != 0 ? 1 : 0);
  EXPECT_EQ(strip_index_lower_bound(two_pieces), least);
  EXPECT_EQ(strip_index_lower_bound(sample::octahedron()), 12U);
  EXPECT_EQ(strip_index_lower_bound(StripMesh{}), 0U);
}

}  // namespace
}  // namespace restrip
