// Claims: no colouring has fewer strips than the bound; the counts of components after splits and changes of colours
// equal a new count.
#include <gtest/gtest.h>

#include <vector>

#include "lod/simplify.hpp"
#include "lod/trail_search.hpp"
#include "meshes/made_mesh.hpp"
#include "restrip/mesh/walks.hpp"
#include "restrip/operations/baked.hpp"
#include "restrip/search/stripify.hpp"
#include "shapes.hpp"

namespace restrip::tools {
namespace {

TEST(ComponentStrips, SomeStripsAreNeededWhateverTheColors) {
  // A triangle and its three neighbours: three ends, so two strips.
  const std::vector<Corners> star{{0, 1, 2}, {1, 0, 3}, {2, 1, 4}, {0, 2, 5}};
  EXPECT_EQ(strips_at_least(StripMesh::build(star, 6)), 2U);
  EXPECT_EQ(strips_at_least(mesh_of(tetrahedron())), 1U);
  EXPECT_EQ(strips_at_least(StripMesh::build(std::vector<Corners>{{0, 1, 2}, {3, 4, 5}}, 6)), 2U);
  // A sheet has two corners with one neighbour each: the ends of one strip.
  EXPECT_EQ(strips_at_least(mesh_of(sheet(5))), 1U);
}

TEST(ComponentStrips, FollowSplits) {
  Soup two = sheet(12);
  const Soup closed = make_mesh(600);
  const auto first = static_cast<Vertex>(two.points.size());
  two.points.insert(two.points.end(), closed.points.begin(), closed.points.end());
  for (const Corners& t : closed.triangles) two.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  const ProgressiveMesh source = simplify(two, {0.1, BoundaryPolicy::move}).mesh;
  StripMesh mesh = StripMesh::build(source.base, source.points.size());
  ComponentStrips counts(mesh);
  ASSERT_EQ(counts.components(), 2U);
  std::vector<Triangle> patch;
  std::size_t boundary_splits = 0;
  std::size_t spared = 0;
  for (const Record& record : source.splits) {
    const auto where = spokes_of(mesh, record);
    using Spokes = VertexSplit::Spokes;
    boundary_splits += where.spokes == Spokes::both ? 0U : 1U;
    fan_triangles(mesh, where.spoke(), patch);
    counts.before_split(mesh, patch);
    const auto done = split_baked(mesh, where, {}, record.v_t);
    edge_triangles(mesh, done.halfedge, patch);
    counts.after_split(mesh, patch);
    counts.add(patch.front(), done.strips);
    const ComponentStrips again(mesh);
    ASSERT_EQ(counts.needed(), again.needed());
    for (Triangle t = 0; t < mesh.triangle_bound(); ++t) {
      ASSERT_EQ(counts.can_spare(t), again.can_spare(t)) << t;
      spared += counts.can_spare(t) ? 1U : 0U;
    }
  }
  EXPECT_GT(boundary_splits, 0U);
  EXPECT_GT(spared, 0U);
  stripify(mesh, Effort::full, Cost::strips());
  counts.recount(mesh);
  const ComponentStrips again(mesh);
  for (Triangle t = 0; t < mesh.triangle_bound(); ++t) EXPECT_EQ(counts.can_spare(t), again.can_spare(t)) << t;
}

}  // namespace
}  // namespace restrip::tools
