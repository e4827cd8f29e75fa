// One object keeps mesh, strips and buffer in step, and undoes frames.
#include "restrip/live_mesh.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "check_buffer.hpp"
#include "restrip/output/strips.hpp"
#include "restrip/search/keeper.hpp"
#include "sample_meshes.hpp"
#include "sheets.hpp"

namespace restrip {
namespace {

TEST(LiveMesh, RefinesAndCoarsensWithTheNumbersOfNewVertices) {
  LiveMesh live(sample::torus(8, 8), {.history = 100'000});
  const std::size_t before = live.mesh().triangle_count();
  const auto h = StripMesh::halfedge(5);
  const Vertex from = live.mesh().from(h);
  const Checked bisected = live.bisect(h);
  ASSERT_TRUE(bisected);
  EXPECT_EQ(bisected.new_vertex(), 64U);
  EXPECT_EQ(live.join_faces(live.edge(from, 64)).refusal, Refusal::other_patch);
  const Checked inside = live.split_face(StripMesh::halfedge(70));
  ASSERT_TRUE(inside);
  EXPECT_EQ(inside.new_vertex(), 65U);
  EXPECT_EQ(live.mesh().triangle_count(), before + 4);
  live.update();
  EXPECT_EQ(live.undoable(), 1U);
  EXPECT_EQ(live.redoable(), 0U);
  ASSERT_TRUE(live.merge(live.edge(from, 64)));
  ASSERT_TRUE(live.join_faces(live.mesh().opposite(live.mesh().spoke(65))));
  EXPECT_EQ(live.mesh().triangle_count(), before);
  const StripMesh::Halfedge spoke = live.mesh().spoke(20);
  const Checked split = live.split({spoke, turn_ccw(live.mesh(), turn_ccw(live.mesh(), spoke))});
  ASSERT_TRUE(split);
  EXPECT_EQ(split.new_vertex(), live.mesh().to(split.rewrite.halfedge));
  EXPECT_EQ(live.keeper().strips(), count_strips(live.mesh()));
  live.update();
  EXPECT_EQ(triangles_of_strips(live.indices()), triangles_of(live.mesh()));
  EXPECT_EQ(live.undoable(), 2U);
  ASSERT_TRUE(live.undo());
  ASSERT_TRUE(live.undo());
  EXPECT_EQ(live.redoable(), 2U);
  EXPECT_EQ(live.mesh().triangle_count(), before);
}

/// A sheet whose triangles are there twice, with opposite windings: few strips, and every operation is refused.
TEST(LiveMesh, RefusesOperationsInATwoSidedSheet) {
  const sample::Triangles list = sample::with_backs(sample::triangles_of(sample::rectangle(12, 12)));
  BuildReport report;
  LiveMesh live(list, 13 * 13, {}, &report);
  EXPECT_GT(report.non_manifold_edges, 0U);
  EXPECT_EQ(triangles_of_strips(live.indices()).size(), list.size());
  EXPECT_LE(live.indices().size(), 14 * list.size() / 10);
  for (Triangle t = 0; t < list.size(); ++t)
    for (unsigned side = 0; side < 3; ++side) {
      const auto h = StripMesh::halfedge(t, side);
      for (const Checked& done : {live.collapse(h), live.flip(h), live.bisect(h)})
        ASSERT_TRUE(done.refusal == Refusal::non_manifold_vertex || done.refusal == Refusal::other_patch);
    }
}

TEST(LiveMesh, OperationsByVerticesAndRefusals) {
  LiveMesh live(sample::octahedron(), {.history = 1000});
  const std::size_t before = live.mesh().triangle_count();
  EXPECT_EQ(live.collapse(live.edge(0, 77)).refusal, Refusal::no_such_edge);
  EXPECT_EQ(live.flip(live.edge(0, 1)).refusal, Refusal::no_such_edge);  // opposite vertices
  const Checked up = live.split({live.edge(4, 0), live.edge(4, 1)});
  ASSERT_TRUE(up);
  EXPECT_EQ(live.mesh().triangle_count(), before + 2);
  EXPECT_TRUE(live.undo());
  EXPECT_EQ(live.mesh().triangle_count(), before);
  EXPECT_FALSE(live.undo());
  EXPECT_TRUE(live.redo());
  EXPECT_EQ(live.mesh().triangle_count(), before + 2);
  LiveMesh without(sample::octahedron());
  EXPECT_FALSE(without.undo());
}

// The lines that the viewer's page prints for C++, as they are printed there.
TEST(LiveMesh, LinesOfThePageKeepTheBufferInStep) {
  std::vector<std::uint32_t> triangles;
  for (const sample::Corners& c : sample::grid(20, 20, true, true, 1))
    triangles.insert(triangles.end(), c.begin(), c.end());
  const std::size_t vertex_count = 400;
  const Vertex v = triangles[0];
  const Vertex w = triangles[1];
  std::vector<std::uint32_t> gpu;
  const auto upload_all = [&](std::span<const std::uint32_t> all) { gpu.assign(all.begin(), all.end()); };
  const auto upload = [&](std::size_t first, std::span<const std::uint32_t> some) {
    gpu.resize(std::max(gpu.size(), first + some.size()));
    std::copy(some.begin(), some.end(), gpu.begin() + static_cast<std::ptrdiff_t>(first));
  };
#include "../../web/viewer/use/live.inc"
  gpu.resize(live.indices().size());
  EXPECT_EQ(live.mesh().triangle_count(), triangles.size() / 3 - 2);
  EXPECT_EQ(triangles_of_strips(std::span<const std::uint32_t>(gpu)), triangles_of(live.mesh()));
}

}  // namespace
}  // namespace restrip
