// The named operations refuse other patches with a reason. What they do: apply_test.cpp.
#include "restrip/operations/refine.hpp"

#include <gtest/gtest.h>

#include <set>

#include "restrip/mesh/walks.hpp"
#include "sample_meshes.hpp"

namespace restrip {
namespace {

// Exactly the triangles that the operation removes must lie around the vertex that goes.
TEST(Refine, RefusesOtherValences) {
  const StripMesh sphere = sample::sphere(1);
  std::set<std::size_t> seen;
  for (Vertex v = 0; v < sphere.vertex_bound(); ++v) {
    const std::size_t valence = spoke_count(sphere, v);
    const Halfedge chord = sphere.opposite(sphere.spoke(v));
    seen.insert(valence);
    EXPECT_EQ(check_apply(sphere, merge_at(sphere, chord)), valence == 4 ? Refusal::granted : Refusal::other_patch);
    EXPECT_EQ(check_apply(sphere, join_faces_at(sphere, chord)), Refusal::other_patch);
  }
  EXPECT_EQ(seen, (std::set<std::size_t>{4, 6}));
  const StripMesh rectangle = sample::rectangle(4, 3);
  for (const OperationPlace& at :
       {split_face_at(rectangle, {}), join_faces_at(rectangle, {}), bisect_at(rectangle, {}), merge_at(rectangle, {})})
    EXPECT_EQ(check_apply(rectangle, at), Refusal::no_such_edge);
  const Halfedge outside = rectangle.opposite(rectangle.spoke(0));
  const Halfedge rim = StripMesh::on_boundary(outside) ? outside : rectangle.opposite(outside);
  ASSERT_TRUE(StripMesh::on_boundary(rim));
  EXPECT_EQ(check_apply(rectangle, split_face_at(rectangle, rim)), Refusal::boundary_edge);
  EXPECT_EQ(check_apply(rectangle, bisect_at(rectangle, rim)), Refusal::granted);
  std::size_t merged = 0;
  for (Vertex v = 0; v < rectangle.vertex_bound(); ++v)
    for (const Halfedge h : sample::spokes_around(rectangle, v)) {
      const bool along = StripMesh::on_boundary(h) || StripMesh::on_boundary(rectangle.opposite(h));
      const Refusal refusal = check_apply(rectangle, merge_at(rectangle, rectangle.opposite(h)));
      const std::size_t triangles = spoke_count(rectangle, v) - (rectangle.leaves_boundary(h) ? 1U : 0U);
      const bool fits = rectangle.leaves_boundary(h) ? along && triangles == 2 : triangles == 4;
      if (refusal == Refusal::granted) ++merged;
      EXPECT_TRUE(fits || refusal != Refusal::granted) << v;
    }
  EXPECT_GT(merged, 0U);
}

}  // namespace
}  // namespace restrip
