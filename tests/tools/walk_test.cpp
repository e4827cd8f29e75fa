// Claims: random operations anywhere leave valid strips; a faulty operation is found, and its trace is shrunk to a few
// operations.
#include "replay/walk.hpp"

#include <gtest/gtest.h>

#include <memory>

#include "common/shrink.hpp"
#include "lod/coloring_check.hpp"
#include "meshes/made_mesh.hpp"
#include "restrip/output/strips.hpp"
#include "restrip/search/stripify.hpp"
#include "shapes.hpp"

namespace restrip::tools {
namespace {

StripMesh stripified(const Soup& soup) {
  StripMesh mesh = StripMesh::build(soup.triangles, soup.points.size());
  stripify(mesh);
  return mesh;
}

TEST(Walk, ClosedMesh) {
  StripMesh mesh = stripified(make_mesh(2000));
  const WalkReport report = walk(mesh, {20'000, 1, 2'000});
  EXPECT_EQ(report.fault, "");
  EXPECT_EQ(report.isolating, 0U);
  EXPECT_GT(report.splits, 1000U);
  EXPECT_GT(report.collapses, 1000U);
  EXPECT_GT(report.flips, 1000U);
}

TEST(Walk, EveryPolicy) {
  for (const Policy policy : {Policy::linked, Policy::quick, Policy::full})
    for (const TieBreak tie_break : {TieBreak::strips, TieBreak::indices})
      for (const Soup& soup : {make_mesh(1000), sheet(15), bow_tie()}) {
        StripMesh mesh = stripified(soup);
        Search search = search_of(policy);
        search.tie_break = tie_break;
        const WalkReport report = walk(mesh, {2'000, 6, 50}, operations_of(policy, search));
        EXPECT_EQ(report.fault, "");
        EXPECT_GT(report.splits + report.collapses + report.flips + report.refused, 1'900U);
        if (report.refused < 1'000) {
          EXPECT_EQ(report.isolating, 0U);
        }
      }
}

TEST(Walk, FindsWhatOperationsKeepWrongBesideTheMesh) {
  const auto with_a_stale_index = [](StripMesh& on) {
    const auto index = std::make_shared<StripIndex>(on);
    Operations operations;
    operations.fault = [index, &on] { return find_fault(on, *index); };
    return operations;
  };
  StripMesh mesh = stripified(make_mesh(500));
  EXPECT_NE(walk(mesh, {200, 2, 100}, with_a_stale_index).fault.find("index"), std::string::npos);
}

TEST(Walk, MeshWithBoundary) {
  StripMesh mesh = stripified(sheet(20));
  EXPECT_EQ(walk(mesh, {20'000, 2, 2'000}).fault, "");
}

TEST(Walk, TinyMeshes) {
  for (const Soup& soup : {tetrahedron(), bow_tie(), sheet(1)})
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      StripMesh mesh = stripified(soup);
      EXPECT_EQ(walk(mesh, {500, seed, 100}).fault, "") << "seed " << seed;
    }
}

TEST(Walk, SameSeedSameWalk) {
  StripMesh a = stripified(make_mesh(500));
  StripMesh b = a;
  const WalkReport first = walk(a, {3'000, 5, 1'000});
  const WalkReport second = walk(b, {3'000, 5, 500});
  EXPECT_EQ(first.splits, second.splits);
  EXPECT_EQ(first.strips, second.strips);
}

/// Now and then a split colours its chord against the rule.
Operations with_a_faulty_split() {
  Operations operations;
  operations.split = [](StripMesh& mesh, const VertexSplit<StripMesh::Halfedge>& where) {
    auto done = restrip::split(mesh, where);
    if (done.valence == 9 && !StripMesh::on_boundary(mesh.opposite(done.halfedge)))
      mesh.set_solid(done.halfedge, !mesh.solid(done.halfedge));
    return done;
  };
  return operations;
}

TEST(Walk, FindsAFaultAndShrinksIt) {
  StripMesh mesh = stripified(make_mesh(1000));
  const WalkReport report = walk(mesh, {50'000, 3, 10'000}, [](StripMesh&) { return with_a_faulty_split(); });
  ASSERT_NE(report.fault, "");
  ASSERT_FALSE(report.trace.empty());
  EXPECT_LE(report.trace.size(), 6U);
  EXPECT_TRUE(report.trace.back().starts_with("then: "));
}

TEST(Walk, FindsAnOperationThatMiscountsItsStrips) {
  Operations operations;
  operations.flip = [](StripMesh& mesh, StripMesh::Halfedge h) {
    auto done = restrip::flip(mesh, h);
    if (done.strips > 0) --done.strips;
    return done;
  };
  StripMesh mesh = stripified(make_mesh(1000));
  EXPECT_NE(walk(mesh, {5'000, 4, 1'000}, [&](StripMesh&) { return operations; }).fault.find("strips, but"),
            std::string::npos);
}

TEST(Walk, FindsAnOperationThatMiscountsItsIsolatedTriangles) {
  Operations operations;
  operations.flip = [](StripMesh& mesh, StripMesh::Halfedge h) {
    auto done = restrip::flip_and_adopt(mesh, h);
    if (done.valence == 4 && mesh.solid(h)) --done.isolated;
    return done;
  };
  StripMesh mesh = stripified(make_mesh(1000));
  EXPECT_NE(walk(mesh, {5'000, 4, 1'000}, [&](StripMesh&) { return operations; }).fault.find("isolated triangles, but"),
            std::string::npos);
}

// Bare flips isolate triangles behind the ports that they give up; the account counts those too.
TEST(Walk, BareRulesTellOfEveryTriangleThatTheyIsolate) {
  for (const Soup& soup : {make_mesh(1000), sheet(15)}) {
    Operations bare;
    bare.split = [](StripMesh& mesh, const VertexSplit<StripMesh::Halfedge>& where) { return split(mesh, where); };
    bare.collapse = [](StripMesh& mesh, StripMesh::Halfedge chord) { return collapse(mesh, chord); };
    bare.flip = [](StripMesh& mesh, StripMesh::Halfedge h) { return flip(mesh, h); };
    StripMesh mesh = stripified(soup);
    const WalkReport report = walk(mesh, {10'000, 8, 100}, [&](StripMesh&) { return bare; });
    EXPECT_EQ(report.fault, "");
    EXPECT_GT(report.flips_isolating, 50U);
    EXPECT_EQ(report.isolated, check_coloring(mesh).isolated);
  }
}

TEST(Walk, RefusesAMeshThatIsFaultyFromTheStart) {
  StripMesh mesh = stripified(tetrahedron());
  for (unsigned side = 0; side < 3; ++side) mesh.set_solid(StripMesh::halfedge(0, side), true);
  EXPECT_NE(walk(mesh, {10, 1, 10}).fault, "");
}

TEST(Shrink, FindsThePairThatFails) {
  std::vector<int> items;
  for (int i = 0; i < 1000; ++i) items.push_back(i);
  const auto fails = [](const std::vector<int>& some) {
    return std::count(some.begin(), some.end(), 17) != 0 && std::count(some.begin(), some.end(), 803) != 0;
  };
  EXPECT_EQ(shrink(items, fails, 2000), (std::vector<int>{17, 803}));
}

TEST(Shrink, StopsWhenItsTriesAreUsedUp) {
  std::vector<int> items(100, 1);
  const auto shrunk = shrink(
      items, [](const std::vector<int>& some) { return !some.empty(); }, 3);
  EXPECT_FALSE(shrunk.empty());
}

}  // namespace
}  // namespace restrip::tools
