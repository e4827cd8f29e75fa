// split_face, bisect and their inverses undo each other, and their checks refuse other patches. That they make the mesh
// that they promise: Apply.DoesWhatTheShippedFunctionsDo; that they report what they change: operations_test.cpp.
#include "restrip/operations/refine.hpp"

#include <gtest/gtest.h>

#include <set>

#include "random_operation.hpp"
#include "restrip/mesh/checks.hpp"
#include "restrip/output/strips.hpp"
#include "sample_meshes.hpp"

namespace restrip {
namespace {

using Halfedge = StripMesh::Halfedge;

TEST(Refine, InversesUndoEachOther) {
  for (const StripMesh& start : sample::meshes())
    for (Triangle t = 0; t < start.triangle_bound(); ++t)
      for (unsigned side = 0; side < 6; ++side) {
        const Halfedge there = StripMesh::halfedge(t, side % 3);
        const Halfedge h = side < 3 ? there : start.opposite(there);
        for (const auto& [forth, back] : {std::pair{OperationKind::split_face, OperationKind::join_faces},
                                          {OperationKind::bisect, OperationKind::merge}}) {
          StripMesh mesh = start;
          const Checked done = perform(mesh, {forth, h, {}});
          if (!done) continue;
          EXPECT_EQ(done.rewrite.valence, forth == OperationKind::split_face ? 3U
                                          : StripMesh::on_boundary(h) || StripMesh::on_boundary(start.opposite(h))
                                              ? 2U
                                              : 4U);
          const Checked undone = perform(mesh, {back, done.rewrite.halfedge, {}});
          ASSERT_TRUE(undone) << describe(undone.refusal);
          EXPECT_EQ(sample::triangles_of(mesh), sample::triangles_of(start));
          EXPECT_TRUE(check_coloring(mesh).valid);
          if (forth == OperationKind::bisect) {
            EXPECT_EQ(mesh.from(undone.rewrite.halfedge), start.from(h));
            EXPECT_EQ(mesh.to(undone.rewrite.halfedge), start.to(h));
          }
        }
      }
}

// Exactly the triangles that the operation removes must lie around v_t.
TEST(Refine, RefusesOtherValences) {
  const StripMesh sphere = sample::sphere(1);
  std::set<std::size_t> seen;
  for (Vertex v = 0; v < sphere.vertex_bound(); ++v) {
    const std::size_t valence = spoke_count(sphere, v);
    const Halfedge chord = sphere.opposite(sphere.spoke(v));
    seen.insert(valence);
    EXPECT_EQ(check_merge(sphere, chord), valence == 4 ? Refusal::granted : Refusal::other_valence);
    EXPECT_EQ(check_join_faces(sphere, chord), Refusal::other_valence);
  }
  EXPECT_EQ(seen, (std::set<std::size_t>{4, 6}));
  const StripMesh rectangle = sample::rectangle(4, 3);
  const Halfedge outside = rectangle.opposite(rectangle.spoke(0));
  const Halfedge rim = StripMesh::on_boundary(outside) ? outside : rectangle.opposite(outside);
  EXPECT_EQ(check_split_face(rectangle, {none}), Refusal::no_such_edge);
  EXPECT_EQ(check_bisect(rectangle, {none}), Refusal::no_such_edge);
  EXPECT_EQ(check_merge(rectangle, {none}), Refusal::no_such_edge);
  EXPECT_EQ(check_join_faces(rectangle, {none}), Refusal::no_such_edge);
  ASSERT_TRUE(StripMesh::on_boundary(rim));
  EXPECT_EQ(check_split_face(rectangle, rim), Refusal::boundary_edge);
  EXPECT_EQ(check_bisect(rectangle, rim), Refusal::granted);
  for (Vertex v = 0; v < rectangle.vertex_bound(); ++v) {
    if (!rectangle.leaves_boundary(rectangle.spoke(v))) continue;
    const std::size_t triangles = spoke_count(rectangle, v) - 1;
    EXPECT_EQ(check_merge(rectangle, rectangle.opposite(rectangle.spoke(v))) == Refusal::other_valence, triangles != 2);
  }
}

// Two triangles that share two sides. The checks of the mesh are asked, although refine.hpp is read before checks.hpp.
TEST(Refine, RefusesBetweenOneSpokeAndItself) {
  const StripMesh mesh = StripMesh::build(std::vector<std::uint32_t>{0, 1, 2, 1, 0, 2}, 3);
  EXPECT_EQ(check_bisect(mesh, StripMesh::halfedge(1, 0)), Refusal::same_spoke);
}

}  // namespace
}  // namespace restrip
