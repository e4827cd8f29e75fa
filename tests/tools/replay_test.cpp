// Claims: a replay ends with the original triangles in valid strips, its counts add up, and a wrong progressive
// mesh is detected. Random operations anywhere leave valid strips and report what they change; a faulty operation is
// found.
#include "replay/replay.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <numeric>
#include <utility>
#include <vector>

#include "folders.hpp"
#include "lod/coloring_check.hpp"
#include "lod/mesh_files.hpp"
#include "lod/simplify.hpp"
#include "measure/vertex_cache.hpp"
#include "meshes/made_mesh.hpp"
#include "replay/methods.hpp"
#include "replay/walk.hpp"
#include "restrip/output/live_buffer.hpp"
#include "restrip/output/strips.hpp"
#include "search/strip_locator.hpp"
#include "shapes.hpp"
#include "support/large.hpp"

namespace restrip::tools {
namespace {

const ReplayOptions quick{10, 0, 0};

ReplayReport replay_of(const Soup& soup, BoundaryPolicy boundary, const ReplayOptions& options = quick,
                       const std::string& method = "local") {
  const ProgressiveMesh mesh = simplify(soup, {0.02, boundary}).mesh;
  return replay(PreparedMethod(method, mesh), soup.triangles, options);
}

TEST(Replay, ClosedMesh) {
  const Soup soup = make_mesh(5000);
  const ReplayReport report = replay_of(soup, BoundaryPolicy::move, {10, 1, 0});
  EXPECT_TRUE(report.valid());
  EXPECT_EQ(report.triangles, soup.triangles.size());
  EXPECT_EQ(report.triangles, report.base_triangles + 2 * report.operations);
  EXPECT_EQ(report.operations_without_rule, 0U);
  EXPECT_EQ(report.operations_isolating, 0U);
  EXPECT_EQ(std::accumulate(report.by_valence.begin(), report.by_valence.end(), std::size_t{0}), report.operations);
  ASSERT_EQ(report.levels.size(), 10U);
  EXPECT_EQ(report.levels.front().triangles, report.base_triangles);
  EXPECT_EQ(report.levels.back().triangles, report.triangles);
  for (const Level& level : report.levels) EXPECT_GE(level.indices, level.triangles + 3 * level.strips - 1);
  EXPECT_GT(report.ns_per_operation, 0);
  EXPECT_GT(report.ns_per_operation_bare, 0);
}

TEST(Replay, EveryPolicyBothWays) {
  std::size_t strips = 20'000;
  const Soup soup = make_mesh(test::large(20'000));
  const ProgressiveMesh mesh = simplify(soup, {0.02, BoundaryPolicy::move}).mesh;
  for (const Method& method : methods()) {
    if (method.kind != Method::Kind::ours) continue;
    const ReplayReport report = replay(PreparedMethod(method.name, mesh), soup.triangles, {10, 0, 1});
    EXPECT_TRUE(report.valid());
    ASSERT_EQ(report.levels_down.size(), report.levels.size());
    for (std::size_t i = 0; i < report.levels.size(); ++i)
      EXPECT_EQ(report.levels_down[i].triangles, report.levels[i].triangles);
    EXPECT_EQ(report.levels_down.back().strips, report.levels.back().strips);
    EXPECT_LT(report.levels.back().strips, strips) << "the costlier policy keeps fewer strips";
    strips = report.levels.back().strips;
    ASSERT_EQ(report.live_buffers.size(), 2U);
    const LiveBufferReport& single = report.live_buffers.front();
    EXPECT_GT(single.bytes_per_operation, 0);
    EXPECT_LT(single.bytes_per_operation, 4 * static_cast<double>(single.states[1].indices) / 10);
    EXPECT_LT(report.live_buffers.back().bytes_per_operation, single.bytes_per_operation);
  }
}

// With one update at the very end, what is written follows from the first and the last buffer.
TEST(Replay, StatesOfLiveBuffers) {
  const Soup soup = make_mesh(4000);
  const ProgressiveMesh mesh = simplify(soup, {0.2, BoundaryPolicy::move}).mesh;
  for (const StripForm form : {StripForm::restart, StripForm::list}) {
    ReplayOptions options = quick;
    options.buffer = {form, {1, 1'000'000}};
    const PreparedMethod prepared(method_named("local"), mesh, {.cost = Cost::indices()});
    const ReplayReport report = replay(prepared, soup.triangles, options);
    EXPECT_TRUE(report.valid());
    ASSERT_EQ(report.live_buffers.size(), 2U);
    for (const LiveBufferReport& buffer : report.live_buffers) {
      ASSERT_EQ(buffer.states.size(), 3U);
      EXPECT_EQ(buffer.states[0].triangles, report.base_triangles);
      EXPECT_EQ(buffer.states[1].triangles, report.triangles);
      EXPECT_EQ(buffer.states[2].triangles, report.base_triangles);
      EXPECT_EQ(buffer.states[0].strip_indices, report.levels.front().indices);
      EXPECT_EQ(buffer.states[1].strip_indices, report.levels.back().indices);
      EXPECT_EQ(buffer.states[2].strip_indices, report.levels_down.front().indices);
    }
    const BufferState& base = report.live_buffers[1].states[0];
    const LayoutOptions layout;
    LiveBuffer buffer({.form = form}, layout);
    buffer.rebuild(prepared.base());
    EXPECT_EQ(base.indices, buffer.size());
    std::vector<std::uint32_t> indices;
    for (const std::uint16_t i : buffer.indices16()) indices.push_back(i == 0xFFFF ? restart_index : i);
    if (form == StripForm::list) indices.resize(3 * base.triangles);
    EXPECT_EQ(base.indices, indices.size());
    EXPECT_DOUBLE_EQ(base.fifo_16, acmr(indices, 16, base.triangles));
    EXPECT_DOUBLE_EQ(base.fifo_32, acmr(indices, 32, base.triangles));
    EXPECT_GT(report.live_buffers[0].bytes_per_operation, report.live_buffers[1].bytes_per_operation);
    EXPECT_EQ(report.levels.back().buffer_indices, report.live_buffers[0].states[1].indices);
    EXPECT_EQ(report.levels.back().acmr_32, report.live_buffers[0].states[1].fifo_32);
  }
}

TEST(Replay, BoundariesAndNothingToSplit) {
  for (const BoundaryPolicy policy : {BoundaryPolicy::lock, BoundaryPolicy::move})
    EXPECT_TRUE(replay_of(sheet(30), policy).valid());
  const ReplayReport report = replay_of(tetrahedron(), BoundaryPolicy::move);
  EXPECT_TRUE(report.valid());
  EXPECT_EQ(report.operations, 0U);
  EXPECT_EQ(report.levels.back().triangles, 4U);
}

TEST(Replay, CyclesComeBackToTheSameMesh) {
  const ReplayReport report = replay_of(sheet(25), BoundaryPolicy::move, {2, 0, 5});
  EXPECT_TRUE(report.valid());
  ASSERT_EQ(report.cycles.size(), 5U);
  for (const Cycle& cycle : report.cycles) {
    EXPECT_EQ(cycle.base.triangles, report.base_triangles);
    EXPECT_EQ(cycle.top.triangles, report.triangles);
  }
}

TEST(Replay, ReportsSomeOfManyCycles) {
  const ReplayReport report = replay_of(sheet(2), BoundaryPolicy::move, {2, 0, 3 * most_reported_cycles});
  EXPECT_TRUE(report.valid());
  ASSERT_LE(report.cycles.size(), most_reported_cycles);
  ASSERT_GE(report.cycles.size(), most_reported_cycles / 2);
  EXPECT_EQ(report.cycles.back().number, 3 * most_reported_cycles);
  for (std::size_t i = 0; i + 1 < report.cycles.size(); ++i) EXPECT_EQ(report.cycles[i].number, 1 + 4 * i);
}

TEST(Replay, FindsMissingAndTurnedTrianglesAndASplitThatDoesNotFit) {
  const Soup soup = make_mesh(500);
  ProgressiveMesh mesh = simplify(soup).mesh;
  std::vector<Corners> missing = soup.triangles;
  missing.pop_back();
  EXPECT_FALSE(replay(PreparedMethod("local", mesh), missing, quick).valid());
  std::vector<Corners> turned = soup.triangles;
  std::swap(turned.front()[0], turned.front()[1]);
  EXPECT_FALSE(replay(PreparedMethod("local", mesh), turned, quick).valid());
  mesh.splits[7].v_l = mesh.splits.back().v_t;  // does not exist yet
  const ReplayReport report = replay(PreparedMethod("local", mesh), soup.triangles, quick);
  EXPECT_GT(report.operations_without_rule, 0U);
  EXPECT_FALSE(report.valid());
}

struct Real {
  const char* file;
  double least_per_strip;  ///< triangles per strip that policy `local` keeps at the finest level
};

class WithoutLoss : public testing::TestWithParam<Real> {};

TEST_P(WithoutLoss, NoSplitIsolatesATriangle) {
  const Real& real = GetParam();
  const auto file = REAL_MESH(real.file);
  const ReplayReport report = replay_of(read_mesh(file), BoundaryPolicy::lock);
  EXPECT_TRUE(report.valid());
  EXPECT_EQ(report.operations_without_rule, 0U);
  EXPECT_EQ(report.operations_isolating, 0U);
  const Level& top = report.levels.back();
  EXPECT_GE(static_cast<double>(top.triangles), real.least_per_strip * static_cast<double>(top.strips));
}

INSTANTIATE_TEST_SUITE_P(RealMeshes, WithoutLoss,
                         testing::Values(Real{"bunny.obj", 11.5}, Real{"nefertiti.obj", 11}, Real{"rocker-arm.obj", 11},
                                         Real{"soccerball_g31.obj", 11}, Real{"fandisk.obj", 11}));

using Halfedge = StripMesh::Halfedge;
using Where = VertexSplit;

/// By one method of the list.
BeginMaintainer by(const std::string& method) {
  return [&method = method_named(method)](StripMesh& mesh) { return method.begin(mesh, {method.search}); };
}

/// The rules, for tests to spoil.
struct Operations : Maintainer {
  using Maintainer::Maintainer;
  Rewrite split(const Where& where, Vertex v_t, std::size_t) override { return restrip::split(mesh_, where, v_t); }
  Rewrite collapse(Halfedge chord, std::size_t) override { return restrip::collapse(mesh_, chord); }
  Rewrite flip(Halfedge h) override { return restrip::flip(mesh_, h); }
};
template <class Faulty>
std::unique_ptr<Maintainer> begin(StripMesh& mesh) {
  return std::make_unique<Faulty>(mesh);
}

TEST(Walk, MeasuresLiveBuffers) {
  StripMesh mesh = stripified(make_mesh(10'000));
  const StripMesh start = mesh;
  WalkOptions options{3'000, 4};
  options.buffer.operations_per_update = {1, 100};
  const WalkReport plain = walk(mesh, options, by("local"));
  EXPECT_EQ(plain.fault, "");
  ASSERT_EQ(plain.live_buffers.size(), 2U);
  for (const LiveBufferReport& buffer : plain.live_buffers) {
    ASSERT_EQ(buffer.states.size(), 2U);
    EXPECT_EQ(buffer.states[0].strip_indices, strip_indices(start).size());
    EXPECT_EQ(buffer.states[1].strip_indices, strip_indices(mesh).size());
    EXPECT_EQ(buffer.states[1].triangles, mesh.triangle_count());
    EXPECT_LT(buffer.states[0].fifo_32, buffer.states[1].fifo_32) << "the order decays";
    EXPECT_LE(buffer.states[1].fifo_32, buffer.states[1].fifo_16);
  }
  EXPECT_LT(plain.live_buffers[1].bytes_per_operation, plain.live_buffers[0].bytes_per_operation);
}

TEST(Walk, EveryWay) {
  for (const Method& method : methods()) {
    if (method.kind == Method::Kind::mesh) continue;
    for (const Cost& cost : {Cost::strips(), Cost::indices()}) {
      if (!(cost == Cost::strips()) && !method.weighs()) continue;
      for (const Soup& soup : {make_mesh(1000), sheet(15), bow_tie()}) {
        StripMesh mesh = stripified(soup);
        const BakedMesh nothing;  // a walk leaves the baked levels at its first step
        const WalkReport report = walk(mesh, {2'000, 6, 50}, [&](StripMesh& on) {
          return method.begin(on, {method.search_under(cost), cost, &nothing});
        });
        EXPECT_EQ(report.fault, "") << method.name;
        EXPECT_GT(report.splits + report.collapses + report.flips + report.refused, 1'900U);
        if (report.refused < 1'000) {
          EXPECT_GT(std::min({report.splits, report.collapses, report.flips}), 100U) << method.name;
        }
        if (report.refused < 1'000 && method.kind == Method::Kind::ours && cost == Cost::strips()) {
          EXPECT_EQ(report.isolating, 0U) << method.name;
        }
      }
    }
  }
}

struct WithAStaleLocator : Operations {
  StripLocator locator;
  explicit WithAStaleLocator(StripMesh& on) : Operations(on), locator(on) {}
  [[nodiscard]] std::string fault() const override { return find_fault(mesh_, locator); }
};

struct WithAStaleKeeper : Operations {
  Keeper keeper;
  explicit WithAStaleKeeper(StripMesh& on) : Operations(on), keeper(on, Policy::local, Cost::indices()) {}
  [[nodiscard]] std::string fault() const override { return find_fault(keeper); }
};

/// Some splits colour the chord against the rule.
struct WithAFaultySplit : Operations {
  using Operations::Operations;
  Rewrite split(const Where& where, Vertex v_t, std::size_t) override {
    auto done = restrip::split(mesh_, where, v_t);
    if (done.valence == 9 && !StripMesh::on_boundary(mesh_.opposite(done.halfedge)))
      mesh_.set_solid(done.halfedge, !mesh_.solid(done.halfedge));
    return done;
  }
};

/// Reports one strip or one isolated triangle too few, now and then.
template <bool isolated>
struct Miscounting : Operations {
  using Operations::Operations;
  Rewrite flip(Halfedge h) override {
    auto done = Operations::flip(h);
    if (mesh_.solid(h)) --(isolated ? done.isolated : done.strips);
    return done;
  }
};

TEST(Walk, FindsFaults) {
  struct Fault {
    BeginMaintainer begin;
    const char* said;
  };
  for (const auto& [faulty, said] : std::vector<Fault>{{begin<WithAStaleLocator>, "locator"},
                                                       {begin<WithAStaleKeeper>, "but the keeper says"},
                                                       {begin<WithAFaultySplit>, ""},
                                                       {begin<Miscounting<false>>, "strips, but"},
                                                       {begin<Miscounting<true>>, "isolated triangles, but"}}) {
    StripMesh mesh = stripified(make_mesh(1000));
    const WalkReport report = walk(mesh, {20'000, 3, 100}, faulty);
    EXPECT_NE(report.fault, "") << said;
    EXPECT_NE(report.fault.find(said), std::string::npos) << report.fault;
    EXPECT_LT(report.fault_step, 20'000U);
  }
  // One that is there from the start.
  StripMesh mesh = stripified(tetrahedron());
  for (unsigned side = 0; side < 3; ++side) mesh.set_solid(StripMesh::halfedge(0, side), true);
  EXPECT_NE(walk(mesh, {10, 1, 10}, by("local")).fault, "");
}

// Flips by the rules alone isolate triangles across ports that they give up; the account includes them.
TEST(Walk, RulesAloneReportEveryTriangleThatTheyIsolate) {
  for (const Soup& soup : {make_mesh(1000), sheet(15)}) {
    StripMesh mesh = stripified(soup);
    const WalkReport report = walk(mesh, {10'000, 8, 100}, by("rules"));
    EXPECT_EQ(report.fault, "");
    EXPECT_GT(report.flips_isolating, 50U);
    EXPECT_EQ(report.isolated, check_coloring(mesh).isolated);
  }
}

}  // namespace
}  // namespace restrip::tools
