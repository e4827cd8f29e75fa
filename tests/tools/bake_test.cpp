// Claims: the strips of every level are valid, equal the report in number, and survive a file unchanged; a closed mesh
// has one strip at every level.
#include "lod/bake.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "lod/baked_file.hpp"
#include "lod/mesh_files.hpp"
#include "lod/simplify.hpp"
#include "lod/trail_search.hpp"
#include "meshes/made_mesh.hpp"
#include "real_meshes.hpp"
#include "replay/replay.hpp"
#include "restrip/output/strips.hpp"
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
  for (std::size_t i = 0; i < of_strips.levels.size(); ++i)
    EXPECT_LT(of_indices.levels[i].indices * 100, of_strips.levels[i].indices * 91) << i;
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

}  // namespace
}  // namespace restrip::tools
