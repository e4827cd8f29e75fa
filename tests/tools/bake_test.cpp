// Claims: the strips of every level are valid, equal the report in number, and survive a file unchanged; a closed mesh
// has one strip at every level.
#include "lod/bake.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "folders.hpp"
#include "lod/baked_file.hpp"
#include "lod/mesh_files.hpp"
#include "lod/simplify.hpp"
#include "lod/trail_search.hpp"
#include "meshes/made_mesh.hpp"
#include "replay/replay.hpp"
#include "restrip/mesh/walks.hpp"
#include "restrip/operations/baked.hpp"
#include "restrip/output/strips.hpp"
#include "restrip/search/stripify.hpp"
#include "shapes.hpp"
#include "support/refusal_of.hpp"

namespace restrip::tools {
namespace {

TEST(Bake, ReportsWhatEveryLevelHas) {
  for (const auto& [soup, cost] : {std::pair{make_mesh(1500), Cost::strips()},
                                   {sheet(18), Cost::strips()},
                                   {tetrahedron(), Cost::strips()},
                                   {make_mesh(1500), Cost::indices()},
                                   {sheet(18), Cost::indices()},
                                   {tetrahedron(), Cost::indices()}}) {
    BakeReport report;
    const BakedMesh baked = bake(simplify(soup, {0.05, BoundaryPolicy::move}).mesh, {20'000, cost}, &report);
    ASSERT_EQ(baked.records.size(), baked.mesh.splits.size());
    StripMesh mesh = baked.base;
    std::size_t strips = check_coloring(mesh).strips;
    EXPECT_EQ(strips, report.base_strips);
    std::size_t most = strips;
    std::size_t fewest = strips == report.components ? 1 : 0;
    for (std::size_t i = 0; i < baked.records.size(); ++i) {
      const Record& record = baked.mesh.splits[i];
      const auto done = split_baked(mesh, spokes_of(mesh, record), baked.records[i], record.v_t);
      const ColoringReport level = check_coloring(mesh);
      ASSERT_TRUE(level.valid);
      ASSERT_EQ(static_cast<int>(level.strips), static_cast<int>(strips) + done.strips);
      strips = level.strips;
      most = std::max(most, strips);
      fewest += strips == report.components ? 1U : 0U;
    }
    EXPECT_EQ(strips, report.top_strips);
    EXPECT_GE(strips, report.top_at_least);
    EXPECT_EQ(report.top_indices, strip_indices(mesh, extract_strips(mesh)).size());
    EXPECT_EQ(report.top_at_least, strips_at_least(mesh));
    EXPECT_EQ(most, report.most_strips);
    EXPECT_EQ(fewest, report.fewest_levels);
  }
}

ReplayReport played(const BakedMesh& baked, const Soup& soup, std::size_t cycles = 0) {
  return replay({method_named("baked"), baked.mesh, {.baked = &baked}}, soup.triangles,
                {.repeats = 0, .cycles = cycles});
}

TEST(Bake, AClosedMeshHasOneStripAtEveryLevel) {
  BakeReport report;
  const Soup soup = make_mesh(4000);
  const BakedMesh baked = bake(simplify(soup, {0.02, BoundaryPolicy::move}).mesh, {}, &report);
  EXPECT_EQ(report.most_strips, 1U);
  const ReplayReport replayed = played(baked, soup, 3);
  EXPECT_TRUE(replayed.valid());
  EXPECT_EQ(replayed.most_strips, 1U);
  EXPECT_EQ(replayed.operations_isolating, 0U);
  EXPECT_EQ(replayed.levels_compared, 2 * 3 * replayed.levels.size());
}

// Every level has fewer indices, most by a tenth, and the changed colours take few bytes.
TEST(Bake, IndicesAreFewerWhereTheyAreTheCost) {
  const Soup soup = make_mesh(4000);
  const ProgressiveMesh mesh = simplify(soup, {0.05, BoundaryPolicy::move}).mesh;
  const BakedMesh strips = bake(mesh);
  const BakedMesh indices = bake(mesh, {.cost = Cost::indices()});
  const ReplayReport of_strips = played(strips, soup);
  const ReplayReport of_indices = played(indices, soup);
  EXPECT_TRUE(of_indices.valid());
  EXPECT_GT(of_indices.levels_compared, 0U);
  ASSERT_EQ(of_strips.levels.size(), of_indices.levels.size());
  std::size_t fewest = 0;
  std::size_t most = 0;
  for (std::size_t i = 0; i < of_strips.levels.size(); ++i) {
    EXPECT_LT(of_indices.levels[i].indices * 100, of_strips.levels[i].indices * 92) << i;
    fewest += of_indices.levels[i].indices;
    most += of_strips.levels[i].indices;
  }
  EXPECT_LT(fewest * 100, most * 90);
  constexpr std::size_t bytes_a_record = 30;  // docs/how-to/baked-strips.md; here the base counts too
  EXPECT_LE(baked_bytes(indices).size(), bytes_a_record * indices.records.size());
}

TEST(Bake, ReplayNoticesStripsThatAreNotTheMeshs) {
  const Soup soup = make_mesh(1000);
  BakedMesh baked = bake(simplify(soup, {0.05, BoundaryPolicy::move}).mesh, {20'000, Cost::strips()});
  EXPECT_TRUE(played(baked, soup).valid());
  // A flip in the last record that closes a cycle or gives a triangle three solid edges: all inner edges solid.
  const StripMesh top = [&] {
    StripMesh mesh = baked.base;
    for (std::size_t i = 0; i < baked.records.size(); ++i)
      split_baked(mesh, spokes_of(mesh, baked.mesh.splits[i]), baked.records[i], baked.mesh.splits[i].v_t);
    return mesh;
  }();
  for (unsigned side = 0; side < 3; ++side)
    if (!top.solid(StripMesh::halfedge(0, side))) baked.records.flips.push_back(StripMesh::halfedge(0, side));
  baked.records.first.back() = static_cast<std::uint32_t>(baked.records.flips.size());
  EXPECT_FALSE(played(baked, soup).valid());
}

TEST(Bake, IsReproducible) {
  const ProgressiveMesh mesh = simplify(make_mesh(1000), {0.05, BoundaryPolicy::move}).mesh;
  for (const Cost& cost : {Cost::strips(), Cost::indices()}) {
    const BakedMesh one = bake(mesh, {20'000, cost});
    const BakedMesh other = bake(mesh, {20'000, cost});
    EXPECT_EQ(one.records.first, other.records.first);
    EXPECT_TRUE(one.records.flips == other.records.flips);
  }
}

TEST(Bake, NamesASplitThatDoesNotFit) {
  ProgressiveMesh mesh = simplify(make_mesh(500)).mesh;
  mesh.splits[7].v_l = mesh.splits.back().v_t;  // does not exist yet
  const std::string said = refusal_of([&] { (void)bake(mesh); });
  EXPECT_NE(said.find("split 7"), std::string::npos) << said;
}

class OneStrip : public testing::TestWithParam<const char*> {};

TEST_P(OneStrip, AtEveryLevelOfARealMesh) {
  const auto file = REAL_MESH(GetParam());
  BakeReport report;
  (void)bake(simplify(read_mesh(file), {0.02, BoundaryPolicy::move}).mesh, {}, &report);
  EXPECT_EQ(report.most_strips, 1U);
}

INSTANTIATE_TEST_SUITE_P(RealMeshes, OneStrip, testing::Values("fandisk.obj", "rocker-arm.obj"));

// ---- counts of strips that components need
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

// ---- trails
std::vector<Triangle> ends_of(const StripMesh& mesh) {
  std::vector<Triangle> ends;
  for (Triangle t = 0; t < mesh.triangle_bound(); ++t)
    if (mesh.solid_degree(t) < 2) ends.push_back(t);
  return ends;
}

std::size_t solid_edges_that_differ(const StripMesh& one, const StripMesh& other) {
  std::size_t n = 0;
  for (Triangle t = 0; t < one.triangle_bound(); ++t)
    for (unsigned side = 0; side < 3; ++side)
      if (one.solid(StripMesh::halfedge(t, side)) != other.solid(StripMesh::halfedge(t, side))) ++n;
  return n / 2;
}

TEST(TrailSearch, EverySuccessIsOneStripLess) {
  for (const Soup& soup : {make_mesh(2000), sheet(20), tetrahedron()}) {
    StripMesh mesh = mesh_of(soup);
    StripLocator locator(mesh);  // every triangle isolated
    TrailSearch search;
    std::size_t joined = 0;
    for (;;) {
      const StripMesh before = mesh;
      const std::size_t strips = locator.strips();
      if (!search.join(mesh, locator, ends_of(mesh), 20'000)) {
        EXPECT_EQ(solid_edges_that_differ(before, mesh), 0U);
        break;
      }
      ++joined;
      ASSERT_EQ(locator.strips(), strips - 1);
      ASSERT_EQ(search.flips().size() % 2, 1U);
      ASSERT_EQ(solid_edges_that_differ(before, mesh), search.flips().size());
      for (const StripMesh::Halfedge h : search.flips()) ASSERT_NE(mesh.solid(h), before.solid(h));
      if (joined % 50 != 0) continue;
      const ColoringReport report = check_coloring(mesh);
      ASSERT_TRUE(report.valid);
      ASSERT_EQ(report.strips, locator.strips());
    }
    const ColoringReport report = check_coloring(mesh);
    EXPECT_TRUE(report.valid);
    EXPECT_EQ(report.strips, locator.strips());
    EXPECT_EQ(report.strips, soup.triangles.size() - joined);
    EXPECT_LE(report.strips, 1 + soup.triangles.size() / 30);
  }
}

TEST(TrailSearch, KeepsToItsBudget) {
  StripMesh mesh = mesh_of(make_mesh(2000));
  stripify(mesh, Effort::full, Cost::strips());
  StripLocator locator(mesh);
  TrailSearch search;
  ASSERT_EQ(locator.strips(), 1U);
  EXPECT_FALSE(search.join(mesh, locator, ends_of(mesh), 10'000));  // one strip has no other to join
  EXPECT_LE(search.states(), 10'000U + 3 * TrailSearch::longest);
}

}  // namespace
}  // namespace restrip::tools
