// Tunnelling joins strips and never harms a colouring. Rounds of it leave few strips, continue where they stopped, keep
// to their budget, and end when strips are few enough.
#include "search/tunnel.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <utility>

#include "restrip/mesh/walks.hpp"
#include "restrip/output/strips.hpp"
#include "restrip/search/stripify.hpp"
#include "sample_meshes.hpp"
#include "search/greedy.hpp"
#include "whole_mesh.hpp"

namespace restrip {
namespace {

TEST(Tunnel, EachJoinTakesOneStripAway) {
  for (StripMesh& mesh : sample::meshes()) {
    StripLocator locator(mesh);  // all isolated
    Tunnel tunnel;
    for (const auto& [states, on_failure] : {std::pair{20U, Tunnel::OnFailure::stay}, {50U, Tunnel::OnFailure::wander}})
      for (Triangle t = 0; t < mesh.triangle_bound(); ++t) {
        const std::size_t before = locator.strips();
        const bool joined = tunnel.join(mesh, locator, t, states, on_failure);
        ASSERT_EQ(locator.strips(), before - (joined ? 1 : 0));
        ASSERT_TRUE(check_coloring(mesh).valid);
        ASSERT_EQ(disagreement(locator, mesh), "");
      }
  }
}

TEST(Tunnel, LooksAtNoMoreStatesThanAllowed) {
  StripMesh mesh = sample::torus(30, 30);
  stripify(mesh, Effort::fast, Cost::strips());
  StripLocator locator(mesh);
  for (const std::uint32_t states : {0U, 1U, 2U, 7U, 100U}) {
    Tunnel tunnel;
    for (Triangle t = 0; t < mesh.triangle_bound(); ++t) tunnel.join(mesh, locator, t, states);
    EXPECT_LE(tunnel.counts().states, tunnel.counts().searches * states);
  }
}

TEST(TunnelRounds, LeaveAsFewStripsAsComponentsOfClosedMeshes) {
  for (StripMesh& mesh : sample::meshes()) {
    stripify_fast(mesh);
    StripLocator locator(mesh);
    Tunnel tunnel;
    TunnelRounds rounds;
    const std::size_t before = locator.strips();
    rounds.run(mesh, locator, tunnel, 100'000, connected_components(mesh));
    EXPECT_LE(locator.strips(), before);
    EXPECT_GE(locator.strips(), connected_components(mesh));
    EXPECT_TRUE(check_coloring(mesh).valid);
    EXPECT_EQ(disagreement(locator, mesh), "");
  }
  StripMesh torus = sample::torus(30, 30);  // every triangle its own strip to begin with
  StripLocator locator(torus);
  Tunnel tunnel;
  TunnelRounds rounds;
  rounds.run(torus, locator, tunnel, 1'000'000);
  EXPECT_EQ(locator.strips(), 1U);
  EXPECT_EQ(rounds.run(torus, locator, tunnel, 1'000), 0U) << "enough already";
}

TEST(TunnelRounds, KeepToTheirBudgetAndGoOnWhereTheyStopped) {
  constexpr std::uint32_t largest = 256;
  const auto run = [](std::size_t budget, std::size_t calls) {
    StripMesh mesh = sample::rectangle(40, 30);
    stripify_fast(mesh);
    StripLocator locator(mesh);
    Tunnel tunnel;
    TunnelRounds rounds(16, largest);
    for (; calls > 0; --calls) {
      EXPECT_LE(rounds.run(mesh, locator, tunnel, budget), budget + largest) << "one search may go beyond";
    }
    return extract_strips(mesh).order;
  };
  EXPECT_EQ(run(50, 300), run(50, 300));
  // Single steps go through the ends as one long run does.
  EXPECT_EQ(run(1, 100).size(), run(100, 1).size());
  EXPECT_NE(run(1, 2000), run(1, 1));
}

TEST(TunnelRounds, BeginOnlyWhereItIsWorthIt) {
  StripMesh mesh = sample::torus(10, 10);
  StripLocator locator(mesh);
  Tunnel tunnel;
  TunnelRounds rounds;
  EXPECT_GT(rounds.run(mesh, locator, tunnel, 100, 1, [](Triangle) { return false; }), 0U) << "triangles were passed";
  EXPECT_EQ(tunnel.counts().searches, 0U);
  rounds.run(mesh, locator, tunnel, 1'000'000, 1, [](Triangle t) { return t == 0; });
  EXPECT_LT(locator.strips(), mesh.triangle_count());
  EXPECT_LT(mesh.solid_degree(0), 3U);
  EXPECT_GT(mesh.solid_degree(0), 0U);
  EXPECT_EQ(disagreement(locator, mesh), "");
}

}  // namespace
}  // namespace restrip
