// A keeper of indices leaves a valid colouring after every operation, tells exactly what each changed, in strips, swaps
// and isolated triangles, and keeps the cost low however long it is used. What it tells is compared with counts of the
// whole mesh.
#include "restrip/search/index_keeper.hpp"

#include <gtest/gtest.h>

#include <random>
#include <stdexcept>
#include <vector>

#include "coloring_cost.hpp"
#include "random_operation.hpp"
#include "restrip/search/stripify.hpp"
#include "sample_meshes.hpp"

namespace restrip {
namespace {

constexpr std::array all_policies{Policy::local, Policy::linked, Policy::quick, Policy::full};

void expect_counted(const IndexKeeper& keeper) {
  ASSERT_TRUE(check_coloring(keeper.mesh()).valid);
  const ColoringChange cost = cost_of(keeper.mesh());
  ASSERT_EQ(keeper.strips(), static_cast<std::size_t>(cost.strips));
  ASSERT_EQ(keeper.swaps(), static_cast<std::size_t>(cost.swaps));
  ASSERT_EQ(keeper.isolated(), static_cast<std::size_t>(cost.isolated));
}

TEST(IndexKeeper, TellsWhatEveryOperationChanged) {
  std::mt19937 random(21);
  for (const Cost& weights : {Cost::indices(), Cost::strips(), Cost{3, 1, 2}})
    for (const Policy policy : all_policies)
      for (StripMesh& mesh : sample::meshes()) {
        IndexKeeper keeper(mesh, policy, weights);
        expect_counted(keeper);
        for (int i = 0; i < 200; ++i) {
          const ColoringChange before = cost_of(mesh);
          const bool done = random_operation(keeper, random, mesh.triangle_count() < 60 || (i / 40) % 2 == 0);
          const ColoringChange change = cost_of(mesh) - before;
          if (done) {
            ASSERT_EQ(keeper.last_change(), change);
          }
          if (i % 50 == 49) {
            const std::size_t cost = keeper.cost();
            const std::size_t saved = keeper.improve(200);
            ASSERT_EQ(saved, cost - keeper.cost());
          }
          expect_counted(keeper);
          if (HasFatalFailure()) return;
        }
        EXPECT_EQ(keeper.cost(), weights.restart * keeper.strips() + weights.swap * keeper.swaps() +
                                     weights.isolated * keeper.isolated());
      }
}

// Random operations make rough meshes; a local minimum of the whole mesh, by chains, is the measure.
TEST(IndexKeeper, IndicesDoNotAge) {
  std::mt19937 random(22);
  const std::array<double, 4> allowed{1.25, 1.20, 1.15, 1.10};
  for (const Policy policy : all_policies) {
    StripMesh mesh = sample::torus(40, 40);
    stripify(mesh, Effort::full, Cost::indices());
    IndexKeeper keeper(mesh, policy);
    for (int round = 0; round < 6; ++round) {
      for (int done = 0; done < 1500;) done += random_operation(keeper, random, round % 2 == 0) ? 1 : 0;
      expect_counted(keeper);
      const auto indices = [](const StripMesh& of) {
        return static_cast<double>(strip_index_count(of, extract_strips(of)));
      };
      StripMesh measure = mesh;
      stripify(measure, Effort::full, Cost::indices());
      EXPECT_LE(indices(mesh), allowed[static_cast<std::size_t>(policy)] * indices(measure))
          << static_cast<int>(policy) << ", round " << round;
    }
  }
}

TEST(IndexKeeper, GoesOnInTheBackground) {
  StripMesh mesh = sample::torus(30, 30);
  stripify_fast(mesh);
  IndexKeeper keeper(mesh);
  std::size_t saved = 0;
  const std::size_t before = keeper.cost();
  const auto priced = [&] { return keeper.counts_of_improve().priced; };
  for (int i = 0; i < 50; ++i) {
    const std::uint64_t start = priced();
    saved += keeper.improve(1000);
    EXPECT_LE(priced() - start, 1100U);
  }
  EXPECT_EQ(before - keeper.cost(), saved);
  EXPECT_LT(keeper.cost(), before * 4 / 5);
  expect_counted(keeper);
}

TEST(IndexKeeper, SameOperationsSameColours) {
  const auto outcome = [](Policy policy) {
    std::mt19937 random(23);
    StripMesh mesh = sample::torus(20, 20);
    stripify_fast(mesh);
    IndexKeeper keeper(mesh, policy);
    for (int done = 0; done < 500;) done += random_operation(keeper, random, done % 2 == 0) ? 1 : 0;
    return strip_indices(mesh, extract_strips(mesh));
  };
  for (const Policy policy : all_policies) EXPECT_EQ(outcome(policy), outcome(policy));
  EXPECT_NE(outcome(Policy::local), outcome(Policy::full));
}

// Steps are edges priced and triangles walked past; with sixteen times the triangles an operation takes as many.
TEST(IndexKeeper, OperationsTakeAsLongOnALargerMesh) {
  for (const Policy policy : all_policies) {
    const auto steps = [&](Vertex size) {
      std::mt19937 random(24);
      StripMesh mesh = sample::torus(size, size);
      stripify(mesh, Effort::full, Cost::indices());
      IndexKeeper keeper(mesh, policy);
      for (int done = 0; done < 1000;) done += random_operation(keeper, random, done % 2 == 0) ? 1 : 0;
      return static_cast<double>(keeper.counts().priced + keeper.walked());
    };
    EXPECT_LT(steps(100), 1.3 * steps(25)) << static_cast<int>(policy);
  }
}

// After a change that is not the keeper's, its counters are right again once it has counted anew.
TEST(IndexKeeper, CountsAnewWhereItIsTold) {
  StripMesh mesh = sample::torus(12, 9);
  IndexKeeper keeper(mesh);
  EXPECT_EQ(keeper.strips(), mesh.triangle_count());
  EXPECT_EQ(keeper.isolated(), mesh.triangle_count());
  stripify_fast(mesh);
  keeper.rebuild();
  expect_counted(keeper);
  for (const StripMesh::Halfedge h : {StripMesh::halfedge(0, 0), StripMesh::halfedge(0, 1), StripMesh::halfedge(0, 2)})
    mesh.set_solid(h, true);
  EXPECT_THROW(keeper.rebuild(), std::invalid_argument);
  EXPECT_FALSE(keeper.up_to_date());
}

}  // namespace
}  // namespace restrip
