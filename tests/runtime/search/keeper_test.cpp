// A keeper's strips, counts and locator are right after any mixture of operations, and they stay few.
#include "restrip/search/keeper.hpp"

#include <gtest/gtest.h>

#include <random>

#include "locator_agrees.hpp"
#include "random_operation.hpp"
#include "restrip/output/strips.hpp"
#include "restrip/search/stripify.hpp"
#include "sample_meshes.hpp"

namespace restrip {
namespace {

void expect_right(const StripKeeper& keeper) {
  if (keeper.locator() != nullptr) {
    ASSERT_TRUE(check_coloring(keeper.mesh()).valid);
    ASSERT_TRUE(agrees(*keeper.locator(), keeper.mesh()));
    return;
  }
  const ColoringReport report = check_coloring(keeper.mesh());
  ASSERT_TRUE(report.valid);
  ASSERT_EQ(report.strips, keeper.strips());
}

TEST(StripKeeper, ChangesItsPolicyOnTheWay) {
  std::mt19937 random(8);
  StripMesh mesh = sample::torus(12, 12);
  StripKeeper keeper(mesh, Policy::linked);
  EXPECT_EQ(keeper.strips(), mesh.triangle_count());
  for (const Policy policy : {Policy::quick, Policy::local, Policy::full, Policy::linked, Policy::quick}) {
    keeper.set_policy(policy);
    for (int i = 0; i < 100; ++i) random_operation(keeper, random, i % 2 == 0);
    expect_right(keeper);
    keeper.improve(100);
    expect_right(keeper);
  }
}

TEST(StripKeeper, IsRightAfterEveryOperation) {
  std::mt19937 random(6);
  for (const Policy policy : {Policy::local, Policy::linked, Policy::quick, Policy::full}) {
    for (StripMesh& mesh : sample::meshes()) {
      StripKeeper keeper(mesh, policy);
      for (int i = 0; i < 400; ++i) {
        random_operation(keeper, random, mesh.triangle_count() < 60 || (i / 80) % 2 == 0);
        if (i % 97 == 0) keeper.improve(200);
        expect_right(keeper);
        if (HasFatalFailure()) return;
      }
    }
  }
}

std::size_t strips_from_scratch(StripMesh mesh) { return stripify(mesh, Effort::full, mesh.triangle_count() * 10); }

// Random operations make meshes on which no stripification is perfect: strips from scratch are the measure.
TEST(StripKeeper, StripsDoNotAge) {
  std::mt19937 random(7);
  StripMesh mesh = sample::torus(60, 60);
  stripify(mesh, Effort::full);
  StripKeeper keeper(mesh, Policy::quick);
  const auto allowed = [&](std::size_t triangles_per_strip) {
    return strips_from_scratch(mesh) + mesh.triangle_count() / triangles_per_strip;
  };
  for (int round = 0; round < 6; ++round) {
    for (int done = 0; done < 1500;) done += random_operation(keeper, random, round % 2 == 0) ? 1 : 0;
    expect_right(keeper);
    EXPECT_LE(keeper.strips(), allowed(60)) << "round " << round;
  }
  keeper.set_policy(Policy::full);
  for (int round = 0; round < 4; ++round) {
    for (int done = 0; done < 1500;) done += random_operation(keeper, random, round % 2 == 0) ? 1 : 0;
    EXPECT_LE(keeper.strips(), allowed(120)) << "round " << round;
  }
  keeper.improve(mesh.triangle_count() * 10);
  EXPECT_LE(keeper.strips(), allowed(1000));
  expect_right(keeper);
}

}  // namespace
}  // namespace restrip
