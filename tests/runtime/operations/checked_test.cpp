// Checked operations do all or nothing: what they refuse leaves the mesh as it is, and says why; what they grant is
// done.
#include <gtest/gtest.h>

#include <vector>

#include "restrip/mesh/checks.hpp"
#include "restrip/operations/operations.hpp"
#include "restrip/search/keeper.hpp"
#include "sample_meshes.hpp"

namespace restrip {
namespace {

using Halfedge = StripMesh::Halfedge;

TEST(Checked, OperationsDoAllOrNothing) {
  StripMesh mesh = sample::rectangle(4, 4);
  Keeper keeper(mesh, Policy::local, Cost::strips());
  const std::vector<sample::Corners> before = sample::triangles_of(mesh);
  const Halfedge edge = mesh.spoke(0);
  EXPECT_EQ(checked_flip(mesh, edge).refusal, Refusal::boundary_edge);
  EXPECT_EQ(checked_flip(keeper, edge).refusal, Refusal::boundary_edge);
  EXPECT_EQ(checked_collapse(mesh, {}).refusal, Refusal::no_such_edge);
  EXPECT_EQ(checked_collapse(keeper, {}).refusal, Refusal::no_such_edge);
  const Halfedge inside = mesh.spoke(6);
  EXPECT_EQ(checked_split(mesh, {inside, inside}).refusal, Refusal::same_spoke);
  EXPECT_EQ(checked_split(mesh, {inside, turn_ccw(mesh, inside)}, 3).refusal, Refusal::vertex_in_use);
  EXPECT_EQ(checked_split(keeper, {inside, turn_ccw(mesh, inside)}, 3).refusal, Refusal::vertex_in_use);
  // Up to this name all vertices would be allocated.
  EXPECT_EQ(checked_split(mesh, {inside, turn_ccw(mesh, inside)}, none - 1).refusal, Refusal::vertex_too_far);
  const auto furthest = static_cast<Vertex>(mesh.vertex_bound() + StripMesh::max_vertex_gap + mesh.triangle_bound());
  EXPECT_EQ(check_split(mesh, {inside, turn_ccw(mesh, inside)}, furthest + 1), Refusal::vertex_too_far);
  EXPECT_EQ(check_split(mesh, {inside, turn_ccw(mesh, inside)}, furthest), Refusal::granted);
  const auto alone = [](Vertex v) { return std::vector<sample::Corners>{{30, 31, v}}; };
  EXPECT_EQ(check_replace(mesh, {}, alone(furthest + 1)), Refusal::vertex_too_far);
  EXPECT_EQ(check_replace(mesh, {}, alone(furthest)), Refusal::granted);
  EXPECT_EQ(sample::triangles_of(mesh), before);
  const Checked up = checked_split(keeper, {inside, turn_ccw(mesh, inside)}, 30);
  ASSERT_TRUE(up);
  EXPECT_EQ(mesh.to(up.rewrite.halfedge), 30U);
  EXPECT_TRUE(checked_collapse(keeper, up.rewrite.halfedge));
  EXPECT_EQ(sample::triangles_of(mesh), before);
}

}  // namespace
}  // namespace restrip
