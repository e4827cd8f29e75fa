// Each policy searches further than the one before it, and so keeps the cost lower through the same operations, for the
// cost of strips and of indices.
#include "restrip/search/policy.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <fstream>
#include <iterator>
#include <limits>
#include <random>
#include <string>
#include <string_view>

#include "random_operations.hpp"
#include "restrip/search/keeper.hpp"
#include "restrip/search/stripify.hpp"
#include "sample_meshes.hpp"

namespace restrip {
namespace {

/// Whether both do the same after the rule.
bool same_steps(const PolicyRow& a, const PolicyRow& b, Cost cost) {
  if (cost == Cost::strips())
    return std::string_view(a.description) == b.description && a.search.states == b.search.states &&
           a.search.enough == b.search.enough;
  return std::string_view(a.for_indices) == b.for_indices;
}

/// The cost after the same operations under each policy, from the shortest look to the longest. On a mesh of a
/// quarter of the size chance decides between the two that look furthest.
void expect_less_with_each_policy(Cost cost, Policy first) {
  std::size_t before = std::numeric_limits<std::size_t>::max();
  const PolicyRow* previous = nullptr;
  for (const PolicyRow& row : policies) {
    if (previous == nullptr && row.policy != first) continue;
    StripMesh mesh = sample::torus(80, 60);
    stripify(mesh, Effort::fast, Cost::strips());
    Keeper keeper(mesh, row.policy, cost);
    std::mt19937 random(3);
    for (int n = 0; n < 6000; ++n) random_operation(keeper, random, n % 2000 < 1000);
    if (previous != nullptr && same_steps(*previous, row, cost))
      EXPECT_EQ(keeper.cost(), before) << row.name;
    else
      EXPECT_LT(keeper.cost(), before) << row.name;
    before = keeper.cost();
    previous = &row;
  }
}

void expect_in(const std::string& text, const std::string& part) {
  EXPECT_NE(text.find(part), std::string::npos) << part;
}

std::string text_of(const char* path) {
  std::ifstream file(std::string(RESTRIP_SOURCES) + path);
  return {std::istreambuf_iterator<char>(file), {}};
}

// The other interfaces have the same defaults; tests/cross compares the table itself.
TEST(Policies, EveryInterfaceHasTheirDefaults) {
  const std::string header = text_of("bindings/c/include/restrip.h");
  const std::string types = text_of("bindings/js/restrip.d.ts");
  const std::string script = text_of("bindings/js/restrip.mjs") + text_of("bindings/js/arguments.mjs");
  const std::string python = text_of("bindings/python/src/restrip/__init__.py");
  static_assert(default_policy == Policy::quick && default_cost == Cost::indices() && default_effort == Effort::fast);
  expect_in(text_of("README.md"),
            "the effort `fast` for strips from scratch and the\npolicy `quick`, both with the cost of indices");
  expect_in(header, "policy is RESTRIP_POLICY_QUICK for RESTRIP_FEWEST_INDICES");
  expect_in(types, "Defaults: 'quick', 'indices', 'restart', 32, no history.");
  expect_in(script, "{ policy = 'quick', cost = 'indices', form = 'restart', bits = 32, history = 0, layout = {} } =");
  expect_in(script, "{ strips: { restart: 1, swap: 0, isolated: 0 }, indices: { restart: 3, swap: 1, isolated: 0 } }");
  expect_in(python, "policy: Policy = \"quick\", cost: Cost = \"indices\"");
  expect_in(python, "effort: Optional[Effort] = \"fast\"");
  expect_in(python, "{\"strips\": (1, 0, 0), \"indices\": (3, 1, 0)}");
  static_assert(Cost::strips() == Cost{1, 0, 0} && Cost::indices() == Cost{3, 1, 0} && Cost::strips() == Cost{});
  static_assert(Effort::fast < Effort::full && Effort::full < Effort::best, "later ones do more");
}

TEST(Policies, EachKeepsFewerStripsThanTheOneBefore) { expect_less_with_each_policy(Cost::strips(), Policy::bare); }
TEST(Policies, EachKeepsFewerIndicesThanTheOneBefore) {
  expect_less_with_each_policy(Cost::indices(), searching_policies().front());
}

}  // namespace
}  // namespace restrip
