// Baked flips produce exactly the colouring they were taken from, and undo it; a sequence played up and down is the
// same bit for bit; what is played out of order is noticed, done by the rules, and leaves a valid colouring.
#include "restrip/operations/baked.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "../../support/random_operations.hpp"
#include "restrip/mesh/checks.hpp"
#include "restrip/output/strips.hpp"
#include "restrip/search/keeper.hpp"
#include "restrip/search/stripify.hpp"
#include "sample_meshes.hpp"

namespace restrip {
namespace {

using Halfedge = StripMesh::Halfedge;
using Where = VertexSplit;
using Spokes = Where::Spokes;
using sample::colors_of;

std::size_t valid_strips(const StripMesh& mesh) {
  const ColoringReport report = check_coloring(mesh);
  EXPECT_TRUE(report.valid);
  return report.strips;
}

Where random_place(const StripMesh& mesh, std::mt19937& random) {
  Where where = random_split(mesh, random_halfedge(mesh, random), random);
  if (where.spokes == Spokes::both && random() % 2 == 0) std::swap(where.left, where.right);
  return where;
}

struct Sequence {
  struct Step {
    Vertex v_s, v_t, v_l, v_r;
  };
  StripMesh base;
  std::vector<Step> steps;
  BakedRecords records;
  std::vector<std::vector<std::uint8_t>> levels;

  [[nodiscard]] static Where where(const StripMesh& mesh, const Step& step) {
    const Halfedge left = step.v_l == none ? Halfedge{} : mesh.spoke(step.v_s, step.v_l);
    const Halfedge right = step.v_r == none ? Halfedge{} : mesh.spoke(step.v_s, step.v_r);
    return {left, right, step.v_l == none ? Spokes::right_only : step.v_r == none ? Spokes::left_only : Spokes::both};
  }
};

Sequence sequence_on(StripMesh mesh, unsigned seed, int tries) {
  stripify(mesh, Effort::fast, Cost::strips());
  Sequence sequence{mesh, {}, {}, {colors_of(mesh)}};
  std::mt19937 random(seed);
  for (int n = 0; n < tries; ++n) {
    const Where where = random_place(mesh, random);
    if (check_split(mesh, where) != Refusal::granted) continue;
    const bool left = where.spokes != Spokes::right_only;
    const bool right = where.spokes != Spokes::left_only;
    const Halfedge first = left ? where.left : where.right;
    const auto v_t = static_cast<Vertex>(mesh.vertex_bound());
    sequence.steps.push_back(
        {mesh.from(first), v_t, left ? mesh.to(where.left) : none, right ? mesh.to(where.right) : none});
    StripMesh plain = mesh;
    split_baked(plain, where, {}, v_t);
    Keeper(mesh, Policy::local, Cost::strips()).split(where, v_t);
    for (const Halfedge h : sample::recolored_edges(plain, mesh)) sequence.records.flips.push_back(h);
    sequence.records.first.push_back(static_cast<std::uint32_t>(sequence.records.flips.size()));
    sequence.levels.push_back(colors_of(mesh));
  }
  return sequence;
}

TEST(Baked, RoundTripsAreTheSameBitForBit) {
  for (const StripMesh& start : {sample::sphere(2), sample::rectangle(6, 5), sample::torus(9, 7)}) {
    const Sequence sequence = sequence_on(start, 11, 300);
    StripMesh mesh = sequence.base;
    BakedPlayer player(mesh, sequence.records);
    const auto expect_level = [&](std::size_t level) {
      ASSERT_EQ(player.level(), level);
      std::vector<std::uint8_t> now = colors_of(mesh);
      now.resize(sequence.levels[level].size());
      ASSERT_EQ(now, sequence.levels[level]);
    };
    std::mt19937 random(5);
    const std::size_t n = sequence.steps.size();
    ASSERT_GT(n, 100U);
    // All the way up, then to levels drawn at random.
    std::size_t goal = n;
    for (int trip = 0; trip < 40; ++trip, goal = random() % (n + 1)) {
      while (player.level() < goal) {
        const auto& step = sequence.steps[player.level()];
        player.split(player.level(), Sequence::where(mesh, step), step.v_t);
        if (trip < 2) expect_level(player.level());
      }
      while (player.level() > goal) {
        const auto& step = sequence.steps[player.level() - 1];
        player.collapse(player.level() - 1, mesh.spoke(step.v_s, step.v_t));
        if (trip < 2) expect_level(player.level());
      }
      expect_level(goal);
      valid_strips(mesh);
    }
    EXPECT_TRUE(player.in_step());
  }
}

TEST(Baked, OutOfOrderIsNoticedAndDoneByTheRules) {
  const Sequence sequence = sequence_on(sample::rectangle(8, 8), 3, 400);
  const std::size_t n = sequence.steps.size();
  StripMesh mesh = sequence.base;
  BakedPlayer player(mesh, sequence.records);
  for (std::size_t i = 0; i < n / 2; ++i)
    player.split(i, Sequence::where(mesh, sequence.steps[i]), sequence.steps[i].v_t);
  EXPECT_TRUE(player.can_split(n / 2));
  EXPECT_TRUE(player.can_collapse(n / 2 - 1));
  EXPECT_FALSE(player.can_split(n / 2 + 1));
  EXPECT_FALSE(player.can_collapse(n / 2 - 2));
  EXPECT_TRUE(player.in_step());  // to ask changes nothing

  // The records that are left, in an order drawn at random, as far as their vertices allow; occasionally one is taken
  // back.
  std::vector<std::size_t> order;
  for (std::size_t i = n / 2 + 1; i < n; ++i) order.push_back(i);
  std::mt19937 random(9);
  std::shuffle(order.begin(), order.end(), random);
  std::size_t splits = 0;
  std::size_t collapses = 0;
  std::size_t strips = valid_strips(mesh);
  const auto check = [&](const Rewrite& done) {
    ASSERT_FALSE(player.in_step());
    const std::size_t now = valid_strips(mesh);
    ASSERT_EQ(static_cast<int>(now), static_cast<int>(strips) + done.strips);
    strips = now;
  };
  for (const std::size_t i : order) {
    const auto& step = sequence.steps[i];
    const auto known = [&](Vertex v) { return v == none || (v < mesh.vertex_bound() && mesh.spoke(v).id != none); };
    if (!known(step.v_s) || !known(step.v_l) || !known(step.v_r)) continue;
    const Where where = Sequence::where(mesh, step);
    if (check_split(mesh, where) != Refusal::granted) continue;
    check(player.split(i, where, step.v_t));
    ++splits;
    const Halfedge chord = mesh.spoke(step.v_s, step.v_t);
    if (random() % 3 != 0 || check_collapse(mesh, chord) != Refusal::granted) continue;
    check(player.collapse(i, chord));
    ++collapses;
  }
  EXPECT_GT(splits, 20U);
  EXPECT_GT(collapses, 5U);
  EXPECT_FALSE(player.can_split(player.level()));

  // Back in step: from the base.
  mesh = sequence.base;
  player.restart();
  for (std::size_t i = 0; i < n; ++i) player.split(i, Sequence::where(mesh, sequence.steps[i]), sequence.steps[i].v_t);
  EXPECT_TRUE(player.in_step());
  EXPECT_EQ(colors_of(mesh), sequence.levels.back());
  player.leave_step();
  EXPECT_FALSE(player.can_collapse(n - 1));
}

}  // namespace
}  // namespace restrip
