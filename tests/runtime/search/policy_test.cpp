// Each policy looks further than the one before it, and so keeps the cost lower through the same operations, be it that
// of strips or of indices.
#include "restrip/search/policy.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <fstream>
#include <iterator>
#include <limits>
#include <random>
#include <string>

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
    stripify(mesh, Effort::fast, Cost::strips());
    Keeper keeper(mesh, row.policy, cost);
    std::mt19937 random(3);
    for (int n = 0; n < 6000; ++n) random_operation(keeper, random, n % 2000 < 1000);
    EXPECT_LT(keeper.cost(), before) << row.name;
    before = keeper.cost();
  }
}

// README has the table as it is here.
TEST(Policies, ReadmeHasTheirTable) {
  std::ifstream file(RESTRIP_README);
  const std::string readme{std::istreambuf_iterator<char>(file), {}};
  for (const PolicyRow& row : policies) {
    const bool bare = row.policy == Policy::bare;
    const std::string strips = bare ? "–" : std::to_string(most_strips_added);
    const std::string indices = bare                          ? "–"
                                : row.policy == Policy::rules ? "grows with the valence"
                                                              : std::to_string(most_indices_added);
    const std::string line = std::string("| `") + row.name + "` | " + row.says + " | " + row.says_indices + " | " +
                             row.state + " | " + row.price + " | " + strips + " | " + indices + " |\n";
    EXPECT_NE(readme.find(line), std::string::npos) << line;
  }
  static_assert(default_policy == Policy::quick && default_cost == Cost::indices() && default_effort == Effort::fast);
  EXPECT_NE(readme.find("Strips are made with `fast`\nand kept with `quick`, for few indices"), std::string::npos);
}

TEST(Policies, EachKeepsFewerStripsThanTheOneBefore) { expect_less_with_each_policy(Cost::strips(), Policy::bare); }
TEST(Policies, EachKeepsFewerIndicesThanTheOneBefore) { expect_less_with_each_policy(Cost::indices(), Policy::local); }

}  // namespace
}  // namespace restrip
