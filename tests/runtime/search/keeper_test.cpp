// Strips, or the cost, stay few in long use; a rule is followed where nothing is cheaper. That colours stay valid, and
// counts and locator right, is in live_random_test.cpp.
#include "restrip/search/keeper.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <random>
#include <stdexcept>

#include "random_operations.hpp"
#include "restrip/operations/apply.hpp"
#include "restrip/output/strips.hpp"
#include "restrip/search/stripify.hpp"
#include "restrip/tables/operations/bisect.hpp"
#include "restrip/tables/operations/refine_face.hpp"
#include "restrip/tables/operations/split_face.hpp"
#include "sample_meshes.hpp"
#include "search/greedy.hpp"
#include "strip_moves.hpp"
#include "whole_mesh.hpp"

namespace restrip {
namespace {

void expect_right(const Keeper& keeper) {
  if (const StripLocator* const locator = detail::locator_of(keeper)) {
    ASSERT_EQ(disagreement(*locator, keeper.mesh()), "");
  }
  ASSERT_TRUE(check_coloring(keeper.mesh()).valid);
  const ColoringChange cost = cost_of(keeper.mesh());
  ASSERT_EQ(keeper.strips(), static_cast<std::size_t>(cost.strips));
  ASSERT_EQ(keeper.swaps(), static_cast<std::size_t>(cost.swaps));
  ASSERT_EQ(keeper.isolated(), static_cast<std::size_t>(cost.isolated));
}

std::size_t strips_from_scratch(StripMesh mesh) {
  return stripify(mesh, Effort::full, Cost::strips(), mesh.triangle_count() * 10);
}

// Random operations make meshes on which no stripification is perfect: strips from scratch are the measure.
TEST(Keeper, StripsDoNotAge) {
  std::mt19937 random(7);
  StripMesh mesh = sample::torus(60, 60);
  stripify(mesh, Effort::full, Cost::strips());
  Keeper keeper(mesh, Policy::quick, Cost::strips());
  const auto allowed = [&](std::size_t triangles_per_strip) {
    return strips_from_scratch(mesh) + mesh.triangle_count() / triangles_per_strip;
  };
  for (int round = 0; round < 6; ++round) {
    for (int done = 0; done < 1500;) done += random_operation(keeper, random, round % 2 == 0) ? 1 : 0;
    expect_right(keeper);
    EXPECT_LE(keeper.strips(), allowed(60)) << "round " << round;
  }
  keeper.keep(Policy::full, Cost::strips());
  for (int round = 0; round < 4; ++round) {
    for (int done = 0; done < 1500;) done += random_operation(keeper, random, round % 2 == 0) ? 1 : 0;
    EXPECT_LE(keeper.strips(), allowed(120)) << "round " << round;
  }
  keeper.improve(mesh.triangle_count() * 10);
  EXPECT_LE(keeper.strips(), allowed(1000));
  expect_right(keeper);
}

// Random operations make rough meshes; strips from scratch are the measure.
TEST(KeeperByCost, IndicesDoNotAge) {
  std::mt19937 random(22);
  for (const Policy policy : searching_policies()) {
    const std::uint32_t looks = row_of(policy).plan.limits.looks;
    const double allowed = looks >= 70 ? 1.15 : looks >= 10 ? 1.20 : 1.25;
    StripMesh mesh = sample::torus(40, 40);
    stripify(mesh, Effort::full, Cost::indices());
    Keeper keeper(mesh, policy, Cost::indices());
    for (int round = 0; round < 6; ++round) {
      for (int done = 0; done < 1500;) done += random_operation(keeper, random, round % 2 == 0) ? 1 : 0;
      expect_right(keeper);
      const auto indices = [](const StripMesh& of) {
        return static_cast<double>(strip_index_count(of, extract_strips(of)));
      };
      StripMesh measure = mesh;
      stripify(measure, Effort::full, Cost::indices());
      EXPECT_LE(indices(mesh), allowed * indices(measure)) << row_of(policy).name << ", round " << round;
    }
  }
}

TEST(KeeperByCost, ContinuesInTheBackground) {
  StripMesh mesh = sample::torus(30, 30);
  stripify_fast(mesh);  // one strip of many swaps
  Keeper keeper(mesh, Policy::quick, Cost::indices());
  std::size_t saved = 0;
  const std::size_t before = keeper.cost();
  const auto improve_often = [&](int times) {
    for (int i = 0; i < times; ++i) saved += keeper.improve(1000);
    expect_right(keeper);
    EXPECT_EQ(before - keeper.cost(), saved);
  };
  improve_often(2);
  EXPECT_GT(keeper.cost(), before * 9 / 10) << "a small budget does a small part of the work";
  improve_often(48);
  EXPECT_LT(keeper.cost(), before * 4 / 5);
  improve_often(2000);
  EXPECT_LT(keeper.cost(), before * 2 / 3);
  // It ends when no chain gains.
  EXPECT_EQ(keeper.improve(1'000'000), 0U);
}

TEST(Keeper, OfAnEmptyMeshHasNothingToImprove) {
  for (const Cost& cost : {Cost::strips(), Cost::indices()})
    for (const PolicyRow& row : policies) {
      StripMesh mesh;
      EXPECT_EQ(Keeper(mesh, row.policy, cost).improve(100'000), 0U) << row.name;
    }
}

// After a change that is not the keeper's, its counters are right again once it has counted again.
TEST(KeeperByCost, CountsAgainWhenAsked) {
  StripMesh mesh = sample::torus(12, 9);
  Keeper keeper(mesh, Policy::quick, Cost::indices());
  EXPECT_EQ(keeper.strips(), mesh.triangle_count());
  EXPECT_EQ(keeper.isolated(), mesh.triangle_count());
  stripify_fast(mesh);
  keeper.rebuild();
  expect_right(keeper);
  for (const StripMesh::Halfedge h : {StripMesh::halfedge(0, 0), StripMesh::halfedge(0, 1), StripMesh::halfedge(0, 2)})
    mesh.set_solid(h, true);
  EXPECT_THROW(keeper.rebuild(), std::invalid_argument);
  EXPECT_FALSE(keeper.up_to_date());
}

// ---- The rule first.

/// Any operation at a random place.
Checked any_operation(Keeper& keeper, std::mt19937& random, bool grow) {
  return perform(keeper, draw(keeper.mesh(), random, all_operations, trend_of(grow)));
}

/// Calls visit(operation) for every split, collapse and flip of the mesh; operation(keeper) does it, if it is possible.
template <class Visit>
void for_each_operation(const StripMesh& mesh, Visit&& visit) {
  for (const Triangle t : moves::all_triangles(mesh))
    for (unsigned side = 0; side < 3; ++side) {
      const Halfedge h = StripMesh::halfedge(t, side);
      visit([h](Keeper& keeper) { return checked_collapse(keeper, h); });
      visit([h](Keeper& keeper) { return checked_flip(keeper, h); });
      using Spokes = VertexSplit::Spokes;
      for (const Spokes alone : {Spokes::left_only, Spokes::right_only})
        visit([h, alone](Keeper& keeper) { return checked_split(keeper, {h, h, alone}); });
      for_each_spoke(mesh, mesh.from(h), [&](Halfedge right) {
        visit([h, right](Keeper& keeper) { return checked_split(keeper, {h, right}); });
      });
    }
}

// Every operation on every colouring of small meshes.
TEST(RuleFirst, NoOperationOnASmallMeshAddsMoreThanTheBounds) {
  std::size_t done = 0;
  std::array<int, 2> most{};
  moves::for_each_small_coloring([&](const StripMesh& mesh, const Cost& /*cost*/) {
    for_each_operation(mesh, [&](auto&& operation) {
      for (const Policy policy : {Policy::quick, Policy::full})
        for (const bool indices : {false, true}) {
          StripMesh copy = mesh;
          Keeper keeper(copy, policy, indices ? Cost::indices() : Cost::strips());
          const auto before = static_cast<int>(keeper.cost());
          if (!operation(keeper)) return;  // refused, whatever the policy
          const ColoringChange now = cost_of(copy);
          const int added = now.price(keeper.weights()) - before;
          most[indices ? 1 : 0] = std::max(most[indices ? 1 : 0], added);
          ++done;
        }
    });
  });
  EXPECT_GT(done, 100'000U);
  EXPECT_EQ(most[0], most_strips_added);
  EXPECT_LE(most[1], most_indices_added);
  EXPECT_GT(most[1], 0);
}

TEST(RuleFirst, ColoursStayAsTheyAreWhereNothingIsCheaper) {
  for (const Cost& cost : {Cost::strips(), Cost::indices()})
    for (const Policy policy : {Policy::local, Policy::quick, Policy::full}) {
      std::size_t taken = 0;
      std::size_t kept = 0;
      StripMesh mesh = sample::rectangle(14, 14);
      stripify(mesh, Effort::fast, cost);
      Keeper keeper(mesh, policy, cost);
      std::mt19937 random(42);
      for (int n = 0; n < 3000; ++n) {
        StripMesh alone = mesh;
        std::mt19937 again = random;
        const RuleCounts before = keeper.rule_counts();
        const bool grow = mesh.triangle_count() < 300 || n % 2 == 0;
        if (!any_operation(keeper, random, grow)) continue;
        const RuleCounts& now = keeper.rule_counts();
        if (now.improved != before.improved) continue;
        Keeper by_rule(alone, Policy::rules, cost);
        ASSERT_TRUE(any_operation(by_rule, again, grow));
        if (now.taken != before.taken) {
          ++taken;
          ASSERT_EQ(sample::colors_of(mesh), sample::colors_of(alone));
        } else {
          ++kept;
          ASSERT_LE(keeper.cost(), by_rule.cost());
        }
      }
      EXPECT_GT(taken, 300U);
      EXPECT_EQ(kept != 0, !(cost == Cost::strips()));
    }
}

// Newest-vertex bisection, of random triangles or of all in turn: each triangle is halved opposite its newest vertex,
// after the triangle beyond if that has another newest vertex. Rules alone make one strip of many swaps here: 1.6
// indices a triangle.
TEST(RuleFirst, BisectionKeepsIndicesFew) {
  for (const Policy policy : searching_policies())
    for (const bool in_turn : {false, true}) {
      const std::uint32_t looks = row_of(policy).plan.limits.looks;
      const double most = looks >= 70 ? 1.38 : looks >= 10 ? 1.42 : 1.45;
      StripMesh mesh = StripMesh::build(std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3}, 4);
      Keeper keeper(mesh, policy, Cost::indices());
      const auto halved = [&](StripMesh::Halfedge h) {  // the side opposite the newest vertex
        const auto next = mesh.next(h);
        const auto last = mesh.next(next);
        if (mesh.to(next) > std::max(mesh.from(h), mesh.to(h))) return h;
        return mesh.to(last) > std::max(mesh.from(next), mesh.to(next)) ? next : last;
      };
      const auto refine = [&](auto& self, StripMesh::Halfedge h) -> void {
        while (!mesh.on_boundary(mesh.opposite(h)) && !(halved(mesh.opposite(h)) == mesh.opposite(h)))
          self(self, halved(mesh.opposite(h)));
        const OperationPlace at = bisect_at(mesh, h);
        keeper.apply(at.table, at.where);
      };
      std::mt19937 random(5);
      Triangle next = 0;
      while (mesh.triangle_count() < 1000) {
        const auto t = static_cast<Triangle>((in_turn ? next++ : random()) % mesh.triangle_bound());
        if (mesh.alive(t)) refine(refine, halved(StripMesh::halfedge(t)));
      }
      expect_right(keeper);
      const auto triangles = static_cast<double>(mesh.triangle_count());
      EXPECT_LE(static_cast<double>(keeper.cost()) + triangles, most * triangles) << row_of(policy).name;
    }
}

}  // namespace
}  // namespace restrip
