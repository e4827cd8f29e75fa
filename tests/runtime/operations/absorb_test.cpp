// Isolated triangles are absorbed into strips, changes are reported, and a failure changes nothing.
#include "operations/absorb.hpp"

#include <gtest/gtest.h>

#include <random>

#include "operations/join.hpp"
#include "random_operation.hpp"
#include "restrip/output/strips.hpp"
#include "restrip/search/keeper.hpp"
#include "sample_meshes.hpp"

namespace restrip {
namespace {

using Halfedge = StripMesh::Halfedge;

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

TEST(Absorb, LeavesFewAlone) {
  StripMesh mesh = sample::rectangle(20, 20);
  std::mt19937 random(5);
  Keeper keeper(mesh, Policy::local, Cost::strips());
  for (int n = 0; n < 2000; ++n) random_operation(keeper, random, mesh.triangle_count() < 800);
  // Isolate triangles by hand, then absorb them: a count from scratch finds the reported change.
  std::size_t absorbed = 0;
  for (int n = 0; n < 3000; ++n) {
    const auto t = static_cast<Triangle>(random() % mesh.triangle_bound());
    if (!mesh.alive(t)) continue;
    const Halfedge h = StripMesh::halfedge(t, 0);
    for (const Halfedge side : {h, StripMesh::next(h), StripMesh::next(StripMesh::next(h))})
      if (mesh.solid(side)) mesh.set_solid(side, false);
    Census expected = census_of(mesh);
    const ColoringChange done = n % 2 == 0 ? absorb(mesh, h) : detail::join_at_edge(mesh, h);
    ASSERT_EQ(census_of(mesh), expected += done);
    absorbed += done.isolated < 0 ? 1U : 0U;
  }
  EXPECT_GT(absorbed, 1500U);
}

}  // namespace
}  // namespace restrip
