// Each policy looks further than the one before it, and so keeps fewer strips through the same operations, under either
// cost.
#include "restrip/search/policy.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <limits>
#include <random>

#include "random_operation.hpp"
#include "restrip/search/keeper.hpp"
#include "restrip/search/stripify.hpp"
#include "sample_meshes.hpp"

namespace restrip {
namespace {

static_assert(policy_named("linked") == &row_of(Policy::linked) && policy_named("none such") == nullptr);

/// Strips after the same operations under each policy, from the shortest look to the longest.
void expect_fewer_with_each_policy(Cost cost, Policy first) {
  std::size_t before = std::numeric_limits<std::size_t>::max();
  for (const PolicyRow& row : policies) {
    if (row.policy < first) continue;
    StripMesh mesh = sample::torus(40, 30);
    stripify(mesh);
    Keeper keeper(mesh, row.policy, cost);
    std::mt19937 random(3);
    for (int n = 0; n < 6000; ++n) random_operation(keeper, random, n % 2000 < 1000);
    EXPECT_LT(keeper.strips(), before) << row.name;
    before = keeper.strips();
  }
}

TEST(Policies, EachKeepsFewerStripsThanTheOneBefore) { expect_fewer_with_each_policy(Cost::strips(), Policy::bare); }
TEST(Policies, EachKeepsFewerStripsForIndicesToo) { expect_fewer_with_each_policy(Cost::indices(), Policy::local); }

}  // namespace
}  // namespace restrip
