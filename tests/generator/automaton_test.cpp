// Claim: the automaton is minimal and has the number of classes that was counted before. What its answers are worth is
// checked by the verifier.
#include "automaton/automaton.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>

namespace restrip::generator {
namespace {

class AutomatonTest : public testing::Test {
 protected:
  const Automaton automaton = make_automaton();
};

// Two classes that nothing distinguishes would be one.
TEST_F(AutomatonTest, IsMinimal) {
  std::vector<std::size_t> block(automaton.classes.size(), 0);
  std::size_t blocks = 1;
  while (true) {
    std::map<std::vector<std::size_t>, std::size_t> numbers;
    std::vector<std::size_t> finer;
    for (std::size_t c = 0; c < automaton.classes.size(); ++c) {
      const ArcClass& arc = automaton.classes[c];
      std::vector<std::size_t> sight{block[c],     c == 0 ? 1U : 0U, arc.boundary ? 1U : 0U,
                                     arc.as_first, arc.as_second,    arc.closing.value_or(both_dashed)};
      for (const auto& cost : arc.costs) sight.push_back(cost ? static_cast<std::size_t>(100 + *cost) : 0);
      for (const auto& step : arc.steps) {
        sight.push_back(step ? block[step->to] : automaton.classes.size());
        if (step) sight.insert(sight.end(), step->before.begin(), step->before.end());
      }
      finer.push_back(numbers.emplace(sight, numbers.size()).first->second);
    }
    block = finer;
    if (numbers.size() == blocks) break;
    blocks = numbers.size();
  }
  EXPECT_EQ(blocks, automaton.classes.size());
}

TEST_F(AutomatonTest, WitnessesLeadToTheirClasses) {
  std::set<std::string> witnesses;
  std::string last;
  for (std::size_t c = 0; c < automaton.classes.size(); ++c) {
    const std::string& witness = automaton.classes[c].witness;
    std::size_t at = 0;
    for (const char letter : witness) {
      const auto found =
          std::find_if(all_letters.begin(), all_letters.end(), [&](Letter l) { return text_of(l) == letter; });
      ASSERT_NE(found, all_letters.end());
      at = automaton.classes[at].steps[static_cast<std::size_t>(found - all_letters.begin())].value().to;
    }
    EXPECT_EQ(at, c) << witness;
    EXPECT_LE(last.size(), witness.size());
    EXPECT_TRUE(witnesses.insert(witness).second);
    last = witness;
  }
}

// Counted before by a program of another language.
TEST_F(AutomatonTest, ClassesAreAsCountedBefore) {
  EXPECT_EQ(automaton.counts.values, 53U);
  EXPECT_EQ(automaton.classes.size(), 201U);
  EXPECT_EQ(automaton.meets.size(), 66U);
  EXPECT_EQ(automaton.meets[0].size(), 103U);
}

}  // namespace
}  // namespace restrip::generator
