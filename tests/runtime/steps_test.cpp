// The promises of the headers about complexity: an operation takes time linear in the valence, under every policy and
// for any number of strands through the patch; dividing, cutting and linking long strips, walking along strips and
// updating buffers take the stated time; and functions stated not to allocate do not. Building, strips from scratch for
// both costs, annealing, and the order for a vertex cache take linear time for any number of triangles at one vertex.
//
// Steps are counted (step_counter.hpp) at two sizes, one twice the other.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <random>
#include <string>
#include <vector>

#include "operations/join.hpp"
#include "output/strip_buffer.hpp"
#include "random_operations.hpp"
#include "restrip/live_mesh.hpp"
#include "restrip/mesh/triangle_list.hpp"
#include "restrip/output/strip_order.hpp"
#include "restrip/output/strips.hpp"
#include "restrip/search/keeper.hpp"
#include "restrip/search/stripify.hpp"
#include "sample_meshes.hpp"
#include "search/strip_locator.hpp"
#include "search/tunnel.hpp"
#include "step_counter.hpp"

namespace restrip {
namespace {

using Halfedge = StripMesh::Halfedge;
using Where = VertexSplit;
using counter::Work;
using counter::work_of;

using counter::constant;
using counter::grows_at_most;
using counter::linear;

/// A cone over a cone, coloured as one strip that leaves the upper cone after every second triangle: k / 2 strands pass
/// through the fan of vertex 0.
StripMesh zigzag(Vertex k) {
  StripMesh mesh = sample::double_cone(k);
  // Triangles 2 i and 2 i + 1 are the upper and the lower one at rim edge i.
  for (Vertex i = 0; i < k; ++i) {
    mesh.set_solid(StripMesh::halfedge(2 * i, 1), true);
    if (i + 1 < k) mesh.set_solid(i % 2 == 0 ? StripMesh::halfedge(2 * i, 2) : StripMesh::halfedge(2 * i + 1, 0), true);
  }
  return mesh;
}

Where middle_of_the_fan(const StripMesh& mesh, Vertex k) {
  return {mesh.spoke(0, 2), mesh.spoke(0, 2 + k / 2), Where::Spokes::both};
}

TEST(Complexity, OperationsAreLinearInTheValenceUnderEveryPolicy) {
  const std::vector<Policy> policies = searching_policies();
  for (const bool zigzags : {true, false}) {
    std::vector<std::array<Work, 2>> split(policies.size());
    std::vector<std::array<Work, 2>> collapse(policies.size());
    for (const unsigned size : {0U, 1U}) {
      const Vertex k = 16'000U << size;
      StripMesh start = zigzags ? zigzag(k) : sample::double_cone(k);
      if (!zigzags) stripify(start, Effort::fast, Cost::strips());
      ASSERT_TRUE(check_coloring(start).valid);
      if (zigzags) {
        ASSERT_EQ(check_coloring(start).strips, 1U);
      }
      for (std::size_t p = 0; p < policies.size(); ++p) {
        StripMesh mesh = start;
        Keeper keeper(mesh, policies[p], Cost::strips());
        Halfedge chord;
        split[p][size] = work_of([&] { chord = keeper.split(middle_of_the_fan(mesh, k)).halfedge; });
        collapse[p][size] = work_of([&] { keeper.collapse(chord); });
        ASSERT_TRUE(check_coloring(mesh).valid);
        ASSERT_EQ(keeper.strips(), check_coloring(mesh).strips);
      }
    }
    for (std::size_t p = 0; p < policies.size(); ++p) {
      SCOPED_TRACE("policy " + std::to_string(p) + (zigzags ? ", zigzag" : ", stripified"));
      EXPECT_TRUE(grows_at_most(linear, split[p][0], split[p][1]));
      EXPECT_TRUE(grows_at_most(linear, collapse[p][0], collapse[p][1]));
    }
  }
}

/// 2 n triangles in one strip between two rows of vertices.
StripMesh band(Vertex n) {
  std::vector<sample::Corners> triangles;
  for (Vertex x = 0; x < n; ++x) {
    triangles.push_back({2 * x, 2 * x + 2, 2 * x + 1});
    triangles.push_back({2 * x + 1, 2 * x + 2, 2 * x + 3});
  }
  StripMesh mesh = StripMesh::build(triangles, 2 * n + 2);
  for (const Halfedge h : sample::dual_edges(mesh)) mesh.set_solid(h, true);
  return mesh;
}

// The middle of a long strip grows, is cut, linked and looked up: at twice the length about one level of its tree more.
TEST(Complexity, ALongStripIsLocatedCutLinkedAndRewrittenInLogarithmicTime) {
  Work growing[2];
  Work cutting[2];
  Work asking[2];
  for (const unsigned size : {0U, 1U}) {
    const Vertex n = 40'000U << size;
    StripMesh mesh = band(n);
    mesh.reserve(2 * n + 2'000, 2 * n + 2'000);
    StripLocator locator(mesh);
    locator.reserve(2 * n + 2'000);
    ASSERT_EQ(locator.strips(), 1U);
    std::vector<Triangle> patch;
    patch.reserve(2'000);
    for (Vertex i = 0; i < 1'000; ++i) {
      const Halfedge h = mesh.spoke(n + i % 50);
      const Where where{h, turn_ccw(mesh, h), Where::Spokes::right_only};
      if (check_split(mesh, where) != Refusal::granted) continue;
      fan_triangles(mesh, where.right, patch);
      growing[size].steps += work_of([&] { locator.before_patch(mesh, patch); }).steps;
      const auto done = split(mesh, where);
      edge_triangles(mesh, done.halfedge, patch);
      growing[size].steps += work_of([&] { locator.after_patch(mesh, patch); }).steps;
    }
    EXPECT_EQ(locator.strips(), 1U);
    std::uint64_t orders = 0;
    asking[size] = work_of([&] {
      for (Triangle t = 0; t < 20'000; ++t) orders += locator.position(t).order;
    });
    EXPECT_GT(orders, 0U);
    for (Triangle t = 0; t < 20'000; t += 7)
      for (unsigned side = 0; side < 3; ++side) {
        const Halfedge h = StripMesh::halfedge(t, side);
        if (!mesh.solid(h)) continue;
        const Work both = work_of([&] {
          locator.cut(mesh, h);
          locator.link(mesh, h);
        });
        cutting[size].steps += both.steps;
        EXPECT_EQ(both.allocations, 0U);
        break;
      }
    EXPECT_LT(cutting[size].steps, 20'000U / 7 * 3'000U);
  }
  EXPECT_TRUE(grows_at_most(constant, growing[0], growing[1]));
  EXPECT_TRUE(grows_at_most(constant, cutting[0], cutting[1]));
  EXPECT_TRUE(grows_at_most(constant, asking[0], asking[1]));
}

// The band is cut after 100 triangles, and the other strip is twice as long in the second mesh.
TEST(Complexity, JoiningTwoEndsWalksTheShorterStrip) {
  Work joining[2];
  for (const unsigned size : {0U, 1U}) {
    const Vertex n = 10'000U << size;
    StripMesh mesh = band(n);
    const Halfedge end = mesh.spoke(100, 101).id != none ? mesh.spoke(100, 101) : mesh.spoke(101, 100);
    mesh.set_solid(end, false);
    joining[size] = work_of([&] { detail::join_end(mesh, end); });
    ASSERT_TRUE(mesh.solid(end));
    EXPECT_EQ(joining[size].allocations, 0U);
  }
  EXPECT_TRUE(grows_at_most(1.0, joining[0], joining[1]));
}

TEST(Complexity, ABufferRewritesTheRunsAroundAChange) {
  Work updating[2];
  for (const unsigned size : {0U, 1U}) {
    const Vertex n = 10'000U << size;
    StripMesh mesh = band(n);
    StripBuffer buffer(mesh);
    std::vector<Triangle> changed;
    mesh.watch(&changed);
    const Halfedge h = StripMesh::halfedge(n, 0);
    const Halfedge inner = mesh.solid(h) ? h : StripMesh::next(h);
    for (const bool solid : {false, true, false, true}) {  // the last one after warm-up
      mesh.set_solid(inner, solid);
      updating[size] = work_of([&] { buffer.update(mesh, changed); });
      changed.clear();
    }
    EXPECT_EQ(updating[size].allocations, 0U);
  }
  EXPECT_TRUE(grows_at_most(constant, updating[0], updating[1]));
}

// Coarsening leaves gaps, which are closed a few at a time: the longest of all updates does not depend on the mesh.
TEST(Complexity, NoUpdateOfABufferTakesLong) {
  Work longest[2];
  for (const unsigned size : {0U, 1U}) {
    StripMesh mesh = sample::torus(60, 60U << size);
    stripify(mesh, Effort::fast, Cost::strips());
    StripBuffer buffer(mesh);
    buffer.reserve(mesh.triangle_bound());
    std::vector<Triangle> changed;
    changed.reserve(10'000);
    mesh.watch(&changed);
    const std::size_t most = mesh.triangle_count() / 4;
    for (Triangle pass = 0; pass < 70 && mesh.triangle_count() > most; ++pass) {
      for (Triangle t = pass % 7; t < mesh.triangle_bound() && mesh.triangle_count() > most; t += 7) {
        if (!mesh.alive(t) || check_collapse(mesh, StripMesh::halfedge(t, t % 3)) != Refusal::granted) continue;
        collapse(mesh, StripMesh::halfedge(t, t % 3));
        const Work work = work_of([&] { buffer.update(mesh, changed); });
        changed.clear();
        longest[size].steps = std::max(longest[size].steps, work.steps);
      }
    }
    EXPECT_LT(mesh.triangle_count(), 2 * most);
  }
  EXPECT_TRUE(grows_at_most(1.6, longest[0], longest[1]));
}

// Under the default policy and cost. The same operations next to one torus and next to three.
TEST(Complexity, UndoTakesTheTimeOfTheFrameNotOfTheMesh) {
  std::array<Work, 2> undo;
  std::array<Work, 2> redo;
  constexpr Vertex vertices = 50 * 50;
  for (const Vertex others : {1U, 3U}) {
    std::vector<std::array<Vertex, 3>> triangles;
    for (Vertex copy = 0; copy <= others; ++copy)
      for (const auto& [a, b, c] : sample::grid(50, 50, true, true, 1))
        triangles.push_back({a + copy * vertices, b + copy * vertices, c + copy * vertices});
    LiveMesh live(StripMesh::build(triangles, (others + 1) * vertices), {.history = 10'000});
    for (Vertex v = 100; v < 120; v += 2) live.collapse(live.edge(v, v + 1));
    live.update();
    ASSERT_EQ(live.undoable(), 1U);
    const std::size_t strips = live.strips();
    undo[others / 2] = work_of([&] { live.undo(); });
    EXPECT_EQ(live.strips(), count_strips(live.mesh()));
    redo[others / 2] = work_of([&] { live.redo(); });
    EXPECT_EQ(live.strips(), strips);
  }
  EXPECT_TRUE(grows_at_most(constant, undo[0], undo[1]));
  EXPECT_TRUE(grows_at_most(constant, redo[0], redo[1]));
}

// Searches of twice the states take little more than twice the steps: chains get longer by a move or two.
TEST(Complexity, SearchesAreLinearInTheirStates) {
  Work searching[2];
  for (const unsigned size : {0U, 1U}) {
    StripMesh torus = sample::torus(60, 60);
    stripify(torus, Effort::full, Cost::strips());
    StripLocator locator(torus);
    Tunnel tunnel;
    std::size_t searches = 0;
    for (Triangle t = 0; t < torus.triangle_bound() && locator.strips() < 3; t += 500)
      for (unsigned side = 0; side < 3; ++side)
        if (torus.solid(StripMesh::halfedge(t, side))) locator.cut(torus, StripMesh::halfedge(t, side));
    searching[size] = work_of([&] {
      for (Triangle t = 0; t < torus.triangle_bound(); ++t)
        if (torus.solid_degree(t) == 1) {
          tunnel.join(torus, locator, t, 200U << size, Tunnel::OnFailure::wander);
          ++searches;
        }
    });
    EXPECT_GT(searches, 0U);
    EXPECT_LE(tunnel.counts().states, tunnel.counts().searches * (200U << size));
    // Per state, since a search that succeeds ends early.
    searching[size].steps /= tunnel.counts().states / 100 + 1;
  }
  EXPECT_TRUE(grows_at_most(linear, searching[0], searching[1]));
}

// The same searches at the same budget in a mesh of sixteen times the triangles, and background work beside them.
TEST(Complexity, OperationsByCostDoNotDependOnTheSizeOfTheMesh) {
  for (const Policy policy : searching_policies()) {
    std::array<Work, 2> operations;
    std::array<Work, 2> improving;
    for (const unsigned size : {0U, 1U}) {
      std::mt19937 random(24);
      StripMesh mesh = sample::torus(25U << 2 * size, 25U << 2 * size);
      stripify(mesh, Effort::full, Cost::indices());
      Keeper keeper(mesh, policy, Cost::indices());
      operations[size] = work_of([&] {
        for (int done = 0; done < 1000;) done += random_operation(keeper, random, done % 2 == 0) ? 1 : 0;
      });
      improving[size] = work_of([&] { keeper.improve(1000); });
    }
    SCOPED_TRACE("policy " + std::to_string(static_cast<int>(policy)));
    EXPECT_TRUE(grows_at_most(1.3, operations[0], operations[1]));
    EXPECT_TRUE(grows_at_most(linear, improving[0], improving[1]));
  }
}

TEST(Complexity, OperationsAllocateNothing) {
  for (const Policy policy : searching_policies()) {
    StripMesh mesh = sample::double_cone(40);
    stripify(mesh, Effort::fast, Cost::strips());
    mesh.reserve(200, 200);
    Keeper keeper(mesh, policy, Cost::strips());
    keeper.reserve(200);
    std::uint64_t allocations = 0;
    for (int round = 0; round < 200; ++round) {
      const Where where{mesh.spoke(0), turn_ccw(mesh, turn_ccw(mesh, mesh.spoke(0))), Where::Spokes::both};
      const Work work = work_of([&] {
        const Halfedge chord = keeper.split(where).halfedge;
        const Halfedge turned = keeper.flip(mesh.spoke(1)).halfedge;
        keeper.flip(turned);
        keeper.collapse(chord);
      });
      if (round >= 150) allocations += work.allocations;  // scratch memory has grown to what the searches need
    }
    EXPECT_EQ(allocations, 0U) << "policy " << static_cast<int>(policy);
  }
}

/// measure(mesh) grows as the number of triangles at the hub does.
template <class Measure>
void expect_linear(std::uint32_t n, Measure&& measure) {
  for (std::size_t kind = 0; kind < sample::hub_meshes(1).size(); ++kind) {
    const sample::HubMesh once = sample::hub_meshes(n)[kind];
    const sample::HubMesh twice = sample::hub_meshes(2 * n)[kind];
    SCOPED_TRACE(once.name);
    EXPECT_TRUE(grows_at_most(linear, measure(once), measure(twice)));
  }
}
/// What run(mesh) takes, after prepare(mesh).
template <class Prepare, class Run>
void expect_linear(std::uint32_t n, Prepare&& prepare, Run&& run) {
  expect_linear(n, [&](const sample::HubMesh& hub) {
    StripMesh mesh = StripMesh::build(hub.triangles, hub.vertices);
    EXPECT_EQ(mesh.triangle_count(), hub.triangles.size());
    prepare(mesh);
    const Work work = work_of([&] { run(mesh); });
    EXPECT_TRUE(check_coloring(mesh).valid);
    return work;
  });
}
constexpr auto nothing = [](StripMesh&) {};
constexpr auto fast = [](StripMesh& mesh) { stripify(mesh, Effort::fast, Cost::strips()); };

TEST(HubSteps, BuildingIsLinear) {
  expect_linear(4'000, [](const sample::HubMesh& hub) {
    BuildReport report;
    const Work work = work_of([&] { (void)StripMesh::build(hub.triangles, hub.vertices, &report); });
    EXPECT_EQ(report.non_manifold_vertices, std::string(hub.name) == "pinched" ? 1U : 0U);
    EXPECT_EQ(report.non_manifold_edges + report.inconsistent_edges, 0U);
    return work;
  });
}

// Pages on one edge, each a triangle and its back.
TEST(HubSteps, PairingThePagesOfABookIsLinear) {
  std::array<Work, 2> pairing;
  for (const unsigned size : {0U, 1U}) {
    const Vertex pages = 2'000U << size;
    std::vector<sample::Corners> list;
    for (Vertex p = 2; p < pages + 2; ++p) list.insert(list.end(), {{0, 1, p}, {1, 0, p}});
    std::vector<std::array<std::uint32_t, 3>> across(list.size());
    BuildReport report;
    pairing[size] = work_of([&] { find_neighbors(TriangleList(list), pages + 2, across, report); });
    EXPECT_EQ(report.non_manifold_edges, 1U);
    // All sides are joined, and no page to its own back.
    for (Triangle t = 0; t < list.size(); ++t) EXPECT_TRUE(across[t][0] != none && across[t][0] / 4 != (t ^ 1U));
  }
  EXPECT_TRUE(grows_at_most(linear, pairing[0], pairing[1]));
}

TEST(HubSteps, StripsFromScratchAreLinear) {
  expect_linear(4'000, nothing, fast);
  expect_linear(4'000, nothing, [](StripMesh& mesh) { stripify(mesh, Effort::fast, Cost::indices()); });
}

TEST(HubSteps, SearchesFromScratchAreLinear) {
  expect_linear(2'000, nothing,
                [](StripMesh& mesh) { stripify(mesh, Effort::full, Cost::strips(), 2 * mesh.triangle_count()); });
}

// Walks along strips end at some length, and triangles without a flaw are not examined one by one.
TEST(HubSteps, AnnealingIsLinear) {
  expect_linear(2'000, nothing,
                [](StripMesh& mesh) { stripify(mesh, Effort::full, Cost::indices(), 20 * mesh.triangle_count()); });
}

TEST(HubSteps, OrderForTheCacheIsLinear) {
  const auto order = [](StripMesh& mesh) { (void)strips_for_vertex_cache(mesh, {.size = 16}); };
  expect_linear(2'000, fast, order);
  expect_linear(2'000, nothing, order);  // each triangle is a strip, all at one vertex
  const auto order_runs = [](StripMesh& mesh) { (void)StripBuffer(mesh); };
  expect_linear(2'000, fast, order_runs);
  expect_linear(2'000, nothing, order_runs);
}

}  // namespace
}  // namespace restrip
