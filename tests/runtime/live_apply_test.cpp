// Custom operations on a LiveMesh: done under its policy and drawn, or refused; undone like any other.
#include <gtest/gtest.h>

#include "check_buffer.hpp"
#include "restrip/live_mesh.hpp"
#include "restrip/operations/apply.hpp"
#include "restrip/output/strips.hpp"
#include "restrip/tables/operations/merge.hpp"
#include "restrip/tables/operations/refine_face.hpp"
#include "sample_meshes.hpp"

namespace restrip {
namespace {

TEST(LiveApply, DoesAndUndoesCustomOperations) {
  LiveMesh live(sample::torus(8, 8), {.history = 10'000});
  const auto before = sample::triangles_of(live.mesh());
  const Checked refined = live.apply(tables::refine_face_rules, StripMesh::halfedge(20));
  ASSERT_TRUE(refined);
  EXPECT_GT(live.mesh().triangle_count(), before.size());
  EXPECT_EQ(live.strips(), count_strips(live.mesh()));
  live.update();
  EXPECT_EQ(triangles_of_strips(live.indices()), triangles_of(live.mesh()));
  EXPECT_FALSE(live.apply(tables::merge_rules, StripMesh::halfedge(20)));
  EXPECT_TRUE(live.apply_anywhere(tables::merge_rules, StripMesh::triangle(refined.rewrite.halfedge)) ||
              places(live.mesh(), tables::merge_rules, StripMesh::triangle(refined.rewrite.halfedge)).empty());
  EXPECT_TRUE(live.apply_anywhere(tables::refine_face_rules, 40));
  live.update();
  ASSERT_TRUE(live.undo());
  ASSERT_TRUE(live.undo());
  EXPECT_EQ(sample::triangles_of(live.mesh()), before);
}

}  // namespace
}  // namespace restrip
