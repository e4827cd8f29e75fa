// Claims: random operations anywhere leave valid strips and report what they change; a faulty operation is found.
#include "replay/walk.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include "lod/coloring_check.hpp"
#include "meshes/made_mesh.hpp"
#include "replay/methods.hpp"
#include "restrip/output/strips.hpp"
#include "search/strip_locator.hpp"
#include "shapes.hpp"

namespace restrip::tools {
namespace {

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

TEST(Walk, FindsFaultsInWhatIsKeptWithTheMesh) {
  struct WithAStaleLocator : Operations {
    StripLocator locator;
    explicit WithAStaleLocator(StripMesh& on) : Operations(on), locator(on) {}
    [[nodiscard]] std::string fault() const override { return find_fault(mesh_, locator); }
  };
  StripMesh mesh = stripified(make_mesh(500));
  EXPECT_NE(walk(mesh, {200, 2, 100}, begin<WithAStaleLocator>).fault.find("locator"), std::string::npos);
}

TEST(Walk, FindsCountersThatAreWrong) {
  struct Meddles : Operations {
    Keeper keeper;
    explicit Meddles(StripMesh& on) : Operations(on), keeper(on, Policy::local, Cost::indices()) {}
    [[nodiscard]] std::string fault() const override { return find_fault(keeper); }
  };
  StripMesh mesh = stripified(make_mesh(500));
  EXPECT_NE(walk(mesh, {200, 2, 100}, begin<Meddles>).fault.find("but the keeper says"), std::string::npos);
}

TEST(Walk, SameSeedSameWalk) {
  StripMesh a = stripified(make_mesh(500));
  StripMesh b = a;
  const WalkReport first = walk(a, {3'000, 5, 1'000}, by("local"));
  const WalkReport second = walk(b, {3'000, 5, 500}, by("local"));
  EXPECT_EQ(first.splits, second.splits);
  EXPECT_EQ(first.strips, second.strips);
}

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

TEST(Walk, FindsAFault) {
  StripMesh mesh = stripified(make_mesh(1000));
  const WalkReport report = walk(mesh, {50'000, 3, 10'000}, begin<WithAFaultySplit>);
  EXPECT_NE(report.fault, "");
  EXPECT_LT(report.fault_step, 50'000U);
}

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

TEST(Walk, FindsOperationsThatMiscount) {
  for (const auto& [faulty, said] : std::vector<std::pair<BeginMaintainer, const char*>>{
           {begin<Miscounting<false>>, "strips, but"}, {begin<Miscounting<true>>, "isolated triangles, but"}}) {
    StripMesh mesh = stripified(make_mesh(1000));
    EXPECT_NE(walk(mesh, {5'000, 4, 1'000}, faulty).fault.find(said), std::string::npos);
  }
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

TEST(Walk, RefusesAMeshThatIsFaultyFromTheStart) {
  StripMesh mesh = stripified(tetrahedron());
  for (unsigned side = 0; side < 3; ++side) mesh.set_solid(StripMesh::halfedge(0, side), true);
  EXPECT_NE(walk(mesh, {10, 1, 10}, by("local")).fault, "");
}

}  // namespace
}  // namespace restrip::tools
