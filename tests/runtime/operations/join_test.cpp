// Ends of strips that meet are joined, wherever they are, and isolated triangles are absorbed or left as they are. That
// no two ends meet after any operation under Policy::local: live_random_test.cpp.
#include "operations/join.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "operations/absorb.hpp"
#include "random_operations.hpp"
#include "restrip/output/strips.hpp"
#include "restrip/search/keeper.hpp"
#include "sample_meshes.hpp"
#include "whole_mesh.hpp"

namespace restrip {
namespace {

using Halfedge = StripMesh::Halfedge;

// A closed strip around a tube of one ring, opened at one edge: its own ends meet. Whatever a flip cuts, its far ends
// do not stay apart, however far away they are.
TEST(Join, FarEndsThatACutPartsAreJoined) {
  const Vertex n = 40;
  std::vector<sample::Corners> ring;
  for (Vertex i = 0; i < n; ++i) {
    const Vertex next = (i + 1) % n;
    ring.push_back({2 * i, 2 * next, 2 * i + 1});
    ring.push_back({2 * i + 1, 2 * next, 2 * next + 1});
  }
  std::size_t flips = 0;
  for (Vertex seam = 0; seam < n; seam += 7) {
    StripMesh mesh = StripMesh::build(ring, std::size_t{2} * n);
    for (Vertex i = 0; i < n; ++i) {
      mesh.set_solid(mesh.spoke(2 * ((i + 1) % n), 2 * i + 1), true);
      mesh.set_solid(mesh.spoke(2 * i, 2 * i + 1), i != seam);
    }
    ASSERT_EQ(ends_of(mesh).own, 1U);
    ASSERT_EQ(count_strips(mesh), 1U);
    for (Triangle t = 0; t < 2 * n; ++t)
      for (unsigned side = 0; side < 3; ++side) {
        StripMesh copy = mesh;
        if (check_flip(copy, StripMesh::halfedge(t, side)) != Refusal::granted) continue;
        Keeper(copy, Policy::local, Cost::strips()).flip(StripMesh::halfedge(t, side));
        EXPECT_EQ(fault_of_ends(copy), "");
        ++flips;
      }
  }
  EXPECT_GT(flips, 500U);
}

// More strip ends around one vertex than join_ends() remembers.
TEST(Join, ManyEndsAroundOneVertex) {
  for (const Vertex k : {15U, 16U, 17U, 40U}) {
    StripMesh mesh = sample::double_cone(k);
    // Each strip is a pair of triangles, one at each apex, except for a few longer ones.
    for (Vertex i = 0; i < k; ++i) mesh.set_solid(mesh.spoke(2 + i, 2 + (i + 1) % k), true);
    ASSERT_EQ(count_strips(mesh), k);
    Census expected = census_of(mesh);
    std::vector<Halfedge> spokes = sample::spokes_around(mesh, 0);
    expected += detail::join_in(mesh, spokes);
    EXPECT_EQ(census_of(mesh), expected);
    EXPECT_LE(count_strips(mesh), k / 2);
    EXPECT_EQ(fault_of_ends(mesh), "");
  }
}

// All triangles are isolated, and each finds an isolated neighbour. So no triangle around the vertex stays isolated,
// whichever spoke it begins at.
TEST(Join, GoesAroundTheWholeFan) {
  for (const StripMesh& mesh : {sample::rectangle(4, 3), sample::tube(5, 2), sample::octahedron()})
    for (Vertex v = 0; v < mesh.vertex_bound(); ++v) {
      const std::vector<Halfedge> spokes = sample::spokes_around(mesh, v);
      for (std::size_t first = 0; first < spokes.size(); ++first) {
        StripMesh copy = mesh;
        Census expected = census_of(mesh);
        std::vector<Halfedge> around = spokes;
        std::rotate(around.begin(), around.begin() + static_cast<std::ptrdiff_t>(first), around.end());
        expected += detail::join_in(copy, around);
        EXPECT_EQ(census_of(copy), expected);
        for (const Halfedge h : spokes)
          EXPECT_TRUE(StripMesh::on_boundary(h) || copy.solid_degree(StripMesh::triangle(h)) > 0) << "vertex " << v;
      }
    }
}

// ---- isolated triangles

ColoringChange absorb(StripMesh& mesh, Halfedge h, int depth = detail::default_absorptions) {
  return detail::absorb_with(
      mesh, h, depth, [&mesh](Halfedge g, bool solid) { mesh.set_solid(g, solid); }, [](Halfedge) {});
}

// Four triangles, the one in the middle in a strip with two of the others: absorbing the third isolates another,
// however often it is passed on. So nothing changes.
TEST(Absorb, ThatFailsChangesNothing) {
  StripMesh mesh = StripMesh::build(std::vector<std::array<Vertex, 3>>{{0, 1, 2}, {1, 0, 3}, {2, 1, 4}, {0, 2, 5}}, 6);
  for (unsigned alone = 0; alone < 3; ++alone) {
    for (unsigned side = 0; side < 3; ++side) mesh.set_solid(StripMesh::halfedge(0, side), side != alone);
    for (const int depth : {0, 1, 2, 3, 4}) {
      const ColoringChange done = absorb(mesh, mesh.opposite(StripMesh::halfedge(0, alone)), depth);
      EXPECT_EQ(done.strips, 0);
      EXPECT_EQ(done.isolated, 0);
      for (unsigned side = 0; side < 3; ++side) EXPECT_EQ(mesh.solid(StripMesh::halfedge(0, side)), side != alone);
    }
  }
}

}  // namespace
}  // namespace restrip
