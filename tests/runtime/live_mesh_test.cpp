// One object keeps mesh, strips and buffer in step, and undoes frames.
#include "restrip/live_mesh.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "form_reader.hpp"
#include "restrip/operations/apply.hpp"
#include "restrip/output/strips.hpp"
#include "restrip/tables/operations/merge.hpp"
#include "restrip/tables/operations/refine_face.hpp"
#include "sample_meshes.hpp"
#include "sheets.hpp"

namespace restrip {
namespace {

/// A sheet whose triangles are there twice, with opposite windings: few strips, and every operation is refused.
TEST(LiveMesh, RefusesOperationsInATwoSidedSheet) {
  const sample::Triangles list = sample::with_backs(sample::triangles_of(sample::rectangle(12, 12)));
  BuildReport report;
  LiveMesh live(list, 13 * 13, {}, &report);
  EXPECT_GT(report.non_manifold_edges, 0U);
  EXPECT_EQ(form_reader::read_strips(live.indices()).size(), list.size());
  EXPECT_LE(live.indices().size(), 14 * list.size() / 10);
  for (Triangle t = 0; t < list.size(); ++t)
    for (unsigned side = 0; side < 3; ++side) {
      const auto h = StripMesh::halfedge(t, side);
      for (const Checked& done : {live.collapse(h), live.flip(h), live.bisect(h)})
        ASSERT_TRUE(done.refusal == Refusal::non_manifold_vertex || done.refusal == Refusal::other_patch);
    }
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
  EXPECT_EQ(form_reader::read_strips(std::span<const std::uint32_t>(gpu)), sample::triangles_of(live.mesh()));
}

// ---- custom operations
TEST(LiveApply, DoesAndUndoesCustomOperations) {
  LiveMesh live(sample::torus(8, 8), {.history = 10'000});
  const auto before = sample::triangles_of(live.mesh());
  const Checked refined = live.apply(tables::refine_face_rules, StripMesh::halfedge(20));
  ASSERT_TRUE(refined);
  EXPECT_GT(live.mesh().triangle_count(), before.size());
  EXPECT_EQ(live.strips(), count_strips(live.mesh()));
  live.update();
  EXPECT_EQ(form_reader::read_strips(live.indices()), sample::triangles_of(live.mesh()));
  EXPECT_FALSE(live.apply(tables::merge_rules, StripMesh::halfedge(20)));
  const Triangle merged = StripMesh::triangle(refined.rewrite.halfedge);
  const Halfedge place = first_place(live.mesh(), tables::merge_rules, merged);
  const bool fits = check_apply(live.mesh(), tables::merge_rules, place) == Refusal::granted;
  EXPECT_EQ(bool(live.apply_anywhere(tables::merge_rules, merged)), fits);
  EXPECT_TRUE(live.apply_anywhere(tables::refine_face_rules, 40));
  live.update();
  ASSERT_TRUE(live.undo());
  ASSERT_TRUE(live.undo());
  EXPECT_EQ(sample::triangles_of(live.mesh()), before);
}

}  // namespace
}  // namespace restrip
