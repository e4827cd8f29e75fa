// Claim: the automaton is minimal and has the number of classes that was counted before, its rules are the same
// whatever an isolated triangle costs, and weights that it cannot serve are refused with a remedy. What its answers are
// worth is checked by the verifier, for the shipped certificate and for other costs.
#include "automaton/automaton.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>
#include <string>

#include "automaton/emit_automaton.hpp"

namespace restrip::generator {
namespace {

class AutomatonTest : public testing::Test {
 protected:
  const Automaton automaton = make_automaton(strips_weights);
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
  const std::vector<Letter>& letters = letters_of(automaton.weights);
  std::set<std::string> witnesses;
  std::string last;
  for (std::size_t c = 0; c < automaton.classes.size(); ++c) {
    const std::string& witness = automaton.classes[c].witness;
    std::size_t at = 0;
    for (const char letter : witness) {
      const auto found = std::find_if(letters.begin(), letters.end(), [&](Letter l) { return text_of(l) == letter; });
      ASSERT_NE(found, letters.end());
      at = automaton.classes[at].steps[static_cast<std::size_t>(found - letters.begin())].value().to;
    }
    EXPECT_EQ(at, c) << witness;
    EXPECT_LE(last.size(), witness.size());
    EXPECT_TRUE(witnesses.insert(witness).second);
    last = witness;
  }
}

// Counted before by a program of another language; and the classes of the automaton before cost was a parameter, whose
// values were pairs and whose letters knew no turns.
TEST_F(AutomatonTest, AsManyClassesAsWereCountedBefore) {
  EXPECT_EQ(automaton.counts.values, 53U);
  EXPECT_EQ(automaton.classes.size(), 201U);
  EXPECT_EQ(automaton.meets.size(), 66U);
  EXPECT_EQ(automaton.meets[0].size(), 103U);
}

// Whatever an isolated triangle costs, the rules are the same: fewest strips and fewest isolated triangles never
// exclude each other.
TEST_F(AutomatonTest, ThePriceOfAnIsolatedTriangleDoesNotMatter) {
  const auto numbers = [](const Automaton& of) {
    const std::string text = automaton_header(of).text;
    return text.substr(text.find("inline constexpr"));
  };
  for (const Weights weights : {Weights{2, 0, 1}, Weights{1, 0, 1}, Weights{1, 0, 1000}})
    EXPECT_EQ(numbers(make_automaton(weights)), numbers(automaton)) << weights.restart << ' ' << weights.isolated;
}

TEST_F(AutomatonTest, TextsAreTheSameEachTime) {
  const Automaton again = make_automaton(strips_weights);
  EXPECT_EQ(automaton_header(automaton).text, automaton_header(again).text);
  EXPECT_EQ(automaton_certificate(automaton).text, automaton_certificate(again).text);
}

// Without dropped cases the arcs of these have no end. What their answers are worth is checked by the verifier and by
// the tests of the runtime.
TEST(AutomatonOfOtherCosts, CommonFactorsDoNotMatter) {
  const Automaton one = make_automaton({1, 1, 1});
  const Automaton two = make_automaton({2, 2, 2});
  ASSERT_EQ(one.classes.size(), two.classes.size());
  for (std::size_t c = 0; c < one.classes.size(); ++c)
    for (Case k = 0; k < case_codes; ++k) {
      ASSERT_EQ(one.classes[c].costs[k].has_value(), two.classes[c].costs[k].has_value());
      if (one.classes[c].costs[k]) {
        ASSERT_EQ(2 * *one.classes[c].costs[k], *two.classes[c].costs[k]);
      }
    }
  EXPECT_EQ(one.meets, two.meets);
}

TEST(AutomatonOfOtherCosts, RefusesWeightsThatItCannotServe) {
  const auto refusal = [](const Weights& weights) -> std::string {
    try {
      return automaton_header(make_automaton(weights)).text;
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
  };
  EXPECT_NE(refusal({15, 1, 0}).find("need more than 8000 kinds of arcs; divide them by a common factor"),
            std::string::npos);
  EXPECT_NE(refusal({0, 1, 0}).find("the weight of a strip is 0; it must be from 1 to 1000"), std::string::npos);
  EXPECT_NE(refusal({3, -1, 0}).find("the weight of a swap is -1"), std::string::npos);
  EXPECT_NE(refusal({3, 1, 1001}).find("the weight of an isolated triangle is 1001"), std::string::npos);
}

}  // namespace
}  // namespace restrip::generator
