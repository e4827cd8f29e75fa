// Claims: a trail joins two strips and reports its flips, on any mesh; a shorter search never finds more than a longer
// one; if nothing can be joined, nothing is changed.
#include "lod/trail_search.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "meshes/made_mesh.hpp"
#include "restrip/output/strips.hpp"
#include "restrip/search/stripify.hpp"
#include "shapes.hpp"

namespace restrip::tools {
namespace {

std::vector<Triangle> ends_of(const StripMesh& mesh) {
  std::vector<Triangle> ends;
  for (Triangle t = 0; t < mesh.triangle_bound(); ++t)
    if (mesh.solid_degree(t) < 2) ends.push_back(t);
  return ends;
}

std::size_t solid_edges_that_differ(const StripMesh& one, const StripMesh& other) {
  std::size_t n = 0;
  for (Triangle t = 0; t < one.triangle_bound(); ++t)
    for (unsigned side = 0; side < 3; ++side)
      if (one.solid(StripMesh::halfedge(t, side)) != other.solid(StripMesh::halfedge(t, side))) ++n;
  return n / 2;
}

TEST(TrailSearch, EverySuccessIsOneStripLess) {
  for (const Soup& soup : {make_mesh(2000), sheet(20), tetrahedron()}) {
    StripMesh mesh = mesh_of(soup);
    StripLocator locator(mesh);  // every triangle isolated
    TrailSearch search;
    std::size_t joined = 0;
    for (;;) {
      const StripMesh before = mesh;
      const std::size_t strips = locator.strips();
      if (!search.join(mesh, locator, ends_of(mesh), 20'000)) {
        EXPECT_EQ(solid_edges_that_differ(before, mesh), 0U);
        break;
      }
      ++joined;
      ASSERT_EQ(locator.strips(), strips - 1);
      ASSERT_EQ(search.flips().size() % 2, 1U);
      ASSERT_EQ(solid_edges_that_differ(before, mesh), search.flips().size());
      for (const StripMesh::Halfedge h : search.flips()) ASSERT_NE(mesh.solid(h), before.solid(h));
      if (joined % 50 != 0) continue;
      const ColoringReport report = check_coloring(mesh);
      ASSERT_TRUE(report.valid);
      ASSERT_EQ(report.strips, locator.strips());
    }
    const ColoringReport report = check_coloring(mesh);
    EXPECT_TRUE(report.valid);
    EXPECT_EQ(report.strips, locator.strips());
    EXPECT_EQ(report.strips, soup.triangles.size() - joined);
    EXPECT_LE(report.strips, 1 + soup.triangles.size() / 30);
  }
}

TEST(TrailSearch, KeepsToItsBudget) {
  StripMesh mesh = mesh_of(make_mesh(2000));
  stripify(mesh, Effort::full, Cost::strips());
  StripLocator locator(mesh);
  TrailSearch search;
  ASSERT_EQ(locator.strips(), 1U);
  EXPECT_FALSE(search.join(mesh, locator, ends_of(mesh), 10'000));  // one strip has no other to join
  EXPECT_LE(search.states(), 10'000U + 3 * TrailSearch::longest);
}

}  // namespace
}  // namespace restrip::tools
