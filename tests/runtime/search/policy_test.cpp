// Each policy looks further than the one before it, and so keeps the cost lower through the same operations, be it that
// of strips or of indices.
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

/// The cost after the same operations under each policy, from the shortest look to the longest. On a mesh of a
/// quarter of the size chance decides between the two that look furthest.
void expect_less_with_each_policy(Cost cost, Policy first) {
  std::size_t before = std::numeric_limits<std::size_t>::max();
  for (const PolicyRow& row : policies) {
    if (row.policy < first) continue;
    StripMesh mesh = sample::torus(80, 60);
    stripify(mesh);
    Keeper keeper(mesh, row.policy, cost);
    std::mt19937 random(3);
    for (int n = 0; n < 6000; ++n) random_operation(keeper, random, n % 2000 < 1000);
    EXPECT_LT(keeper.cost(), before) << row.name;
    before = keeper.cost();
  }
}

TEST(Policies, EachKeepsFewerStripsThanTheOneBefore) { expect_less_with_each_policy(Cost::strips(), Policy::bare); }
TEST(Policies, EachKeepsFewerIndicesThanTheOneBefore) { expect_less_with_each_policy(Cost::indices(), Policy::local); }

}  // namespace
}  // namespace restrip
