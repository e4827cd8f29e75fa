// Claim: what docs/theory.md section 5 says of k <= 8 holds for every k; on the boundary one triangle may be isolated.
// Where a split and a collapse inside the mesh first cost a strip, k = 4, is known from the tables' search.
#include "automaton/facts.hpp"

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <utility>

namespace restrip::verify {
namespace {

TEST(AutomatonFacts, WorstOfEveryFan) {
  const Facts facts = facts_of_every_fan();
  const std::map<std::pair<std::string, std::string>, std::pair<int, std::size_t>> expected{
      {{"split", "strips"}, {1, 4}},
      {{"split", "isolated"}, {0, 3}},
      {{"split with a = 1", "strips"}, {0, 3}},
      {{"split with a = 1", "isolated"}, {0, 3}},
      {{"collapse", "strips"}, {1, 4}},
      {{"collapse", "isolated"}, {0, 3}},
      {{"open split", "strips"}, {1, 3}},
      {{"open split", "isolated"}, {0, 1}},
      {{"open collapse", "strips"}, {1, 3}},
      {{"open collapse", "isolated"}, {1, 1}},
      {{"boundary split", "strips"}, {1, 2}},
      {{"boundary split", "isolated"}, {1, 2}},
      {{"boundary collapse", "strips"}, {0, 1}},
      {{"boundary collapse", "isolated"}, {1, 1}}};
  ASSERT_EQ(facts.facts.size(), expected.size());
  for (const Fact& fact : facts.facts) {
    const auto& [worst, k] = expected.at({fact.operations, fact.measure});
    EXPECT_EQ(fact.worst, worst) << fact.operations << ' ' << fact.measure;
    EXPECT_EQ(fact.k, k) << fact.operations << ' ' << fact.measure << ' ' << fact.witness;
  }
  EXPECT_GT(facts.pairs, 100000U);
}

}  // namespace
}  // namespace restrip::verify
