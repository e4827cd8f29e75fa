// Each policy looks further than the one before it, and so keeps fewer strips through the same operations. Both keepers
// know all four.
#include "restrip/search/policy.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <limits>
#include <random>

#include "random_operation.hpp"
#include "restrip/search/index_keeper.hpp"
#include "restrip/search/keeper.hpp"
#include "restrip/search/stripify.hpp"
#include "sample_meshes.hpp"

namespace restrip {
namespace {

static_assert(Policy::local < Policy::linked && Policy::linked < Policy::quick && Policy::quick < Policy::full);

/// Strips after the same operations under each policy, from the shortest look to the longest.
template <class Keeper>
void expect_fewer_with_each_policy() {
  std::size_t before = std::numeric_limits<std::size_t>::max();
  for (const Policy policy : {Policy::local, Policy::linked, Policy::quick, Policy::full}) {
    StripMesh mesh = sample::torus(40, 30);
    stripify(mesh);
    Keeper keeper(mesh, policy);
    std::mt19937 random(3);
    for (int n = 0; n < 6000; ++n) random_operation(keeper, random, n % 2000 < 1000);
    EXPECT_LT(keeper.strips(), before) << "policy " << static_cast<int>(policy);
    before = keeper.strips();
  }
}

TEST(Policies, EachKeepsFewerStripsThanTheOneBefore) { expect_fewer_with_each_policy<StripKeeper>(); }
TEST(Policies, EachKeepsFewerStripsForIndicesToo) { expect_fewer_with_each_policy<IndexKeeper>(); }

}  // namespace
}  // namespace restrip
