// Claims: the checks pass correct meshes and reject each kind of fault. A check that rejects nothing proves nothing.
#include "lod/coloring_check.hpp"

#include <gtest/gtest.h>

#include "restrip/mesh/walks.hpp"
#include "restrip/output/strips.hpp"
#include "search/strip_locator.hpp"
#include "shapes.hpp"

namespace restrip::tools {
namespace {

TEST(FindFaults, PassesGreedyStrips) {
  for (const Soup& soup : {tetrahedron(), sheet(6), bow_tie()}) {
    const StripMesh mesh = stripified(soup);
    EXPECT_TRUE(find_faults(mesh).empty());
    for (Vertex v = 0; v < mesh.vertex_bound(); ++v) EXPECT_EQ(find_fault_around(mesh, v), "");
  }
}

TEST(FindFaults, RejectsThreeSolidEdgesAndASolidCycle) {
  StripMesh mesh = mesh_of(tetrahedron());
  for (unsigned side = 0; side < 3; ++side) mesh.set_solid(StripMesh::halfedge(0, side), true);
  EXPECT_FALSE(find_faults(mesh).empty());
  EXPECT_NE(find_fault_around(mesh, 0), "");
  StripMesh ring = mesh_of(sheet(4));
  const Vertex inner = 6;
  for_each_spoke(ring, inner, [&](StripMesh::Halfedge h) { ring.set_solid(h, true); });
  EXPECT_FALSE(find_faults(ring).empty());
  EXPECT_NE(find_fault_around(ring, inner).find("cycle"), std::string::npos);
}

TEST(FindFault, OfALocatorThatIsNoLongerTrue) {
  StripMesh mesh = mesh_of(tetrahedron());
  mesh.set_solid(StripMesh::halfedge(0, 0), true);
  const StripLocator locator(mesh);
  EXPECT_EQ(find_fault(mesh, locator), "");
  mesh.set_solid(StripMesh::halfedge(0, 0), false);
  EXPECT_EQ(find_fault(mesh, locator), "4 strips, but the locator has 3");
  mesh.set_solid(StripMesh::halfedge(0, 1), true);
  EXPECT_NE(find_fault(mesh, locator).find("in the wrong place"), std::string::npos);
}

TEST(DecodeStrips, FollowsTheRulesOfTheCard) {
  // Two strips; the second turns the same way twice, so one index is repeated.
  const std::vector<std::uint32_t> indices{0, 1, 2, 3, restart_index, 4, 5, 6, 5, 7};
  EXPECT_EQ(decode_strips(indices), (std::vector<Corners>{{0, 1, 2}, {2, 1, 3}, {4, 5, 6}, {6, 5, 7}}));
  EXPECT_TRUE(decode_strips(std::vector<std::uint32_t>{0, 1, restart_index, 2, 3}).empty());
}

TEST(DecodeStrips, GivesTheMeshBackAndNoticesAMissingIndex) {
  const StripMesh mesh = stripified(sheet(7));
  std::vector<std::uint32_t> indices = strip_indices(mesh, extract_strips(mesh));
  const auto expected = sorted_triangles(sheet(7).triangles);
  EXPECT_EQ(sorted_triangles(decode_strips(indices)), expected);
  indices.pop_back();
  EXPECT_NE(sorted_triangles(decode_strips(indices)), expected);
}

TEST(SortedTriangles, DistinguishOrientations) {
  EXPECT_EQ(sorted_triangles({{1, 2, 0}}), sorted_triangles({{2, 0, 1}}));
  EXPECT_NE(sorted_triangles({{1, 2, 0}}), sorted_triangles({{2, 1, 0}}));
  EXPECT_TRUE(sorted_triangles({{1, 1, 0}}).empty());
}

}  // namespace
}  // namespace restrip::tools
