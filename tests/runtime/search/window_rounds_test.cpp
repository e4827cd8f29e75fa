// Rounds of windows lower the cost and report the change, continue where they stopped, and keep to their budget. The
// reports are compared with the strips as they are written.
#include "restrip/search/impl/window_rounds.hpp"

#include <gtest/gtest.h>

#include <cstdint>

#include "coloring_cost.hpp"
#include "restrip/output/strips.hpp"
#include "restrip/search/stripify.hpp"
#include "sample_meshes.hpp"

namespace restrip {
namespace {

TEST(WindowRounds, LowerTheCostAndReportIt) {
  for (StripMesh& mesh : sample::meshes())
    for (const Cost cost : {Cost::indices(), Cost::strips(), Cost{3, 1, 2}}) {
      stripify(mesh, Effort::fast, Cost::strips());
      const ColoringChange before = cost_of(mesh);
      const std::size_t indices = strip_indices(mesh).size();
      WindowRounds rounds(cost);
      const WindowChange done = rounds.run(mesh, WindowRounds::no_limit);
      EXPECT_TRUE(check_coloring(mesh).valid);
      EXPECT_EQ(cost_of(mesh) - before, done.change);
      const auto more = static_cast<int>(strip_indices(mesh).size()) - static_cast<int>(indices);
      EXPECT_EQ(more, 3 * done.change.strips + done.change.swaps + done.windings);
      EXPECT_LE(done.change.price(cost) + int{cost.swap} * done.windings, 0);
    }
  StripMesh torus = sample::torus(40, 30);
  stripify(torus, Effort::fast, Cost::indices());
  WindowRounds rounds;
  EXPECT_LT(rounds.run(torus, WindowRounds::no_limit).change.price(Cost::indices()), -100);
}

TEST(WindowRounds, KeepToTheirBudgetAndGoOnWhereTheyStopped) {
  constexpr WindowLimits small{.triangles = 15};
  const auto start = [] {
    StripMesh mesh = sample::rectangle(30, 20);
    stripify(mesh, Effort::fast, Cost::indices());
    return mesh;
  };
  StripMesh at_once = start();
  WindowRounds one_round;
  one_round.run(at_once, WindowRounds::no_limit, small);
  StripMesh in_steps = start();
  WindowRounds steps;
  while (steps.counts().windows < one_round.counts().windows) {
    const std::uint64_t windows = steps.counts().windows;
    const std::uint64_t before = steps.spent();
    steps.run(in_steps, 1, small);
    ASSERT_LE(steps.counts().windows, windows + 1) << "one window may go beyond the budget";
    ASSERT_GT(steps.spent(), before);
  }
  EXPECT_EQ(extract_strips(in_steps).order, extract_strips(at_once).order);
  EXPECT_EQ(steps.counts().tried, one_round.counts().tried);
}

}  // namespace
}  // namespace restrip
