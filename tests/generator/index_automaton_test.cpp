// Claim: the index automaton has as many classes as a program of another language counted before, dropping cases leaves
// a third of them, and weights that need too many are refused with a remedy. What its answers are worth is checked by
// the verifier and by the tests of the runtime.
#include "automaton/index_automaton.hpp"

#include <gtest/gtest.h>

#include <set>
#include <stdexcept>
#include <string>

#include "automaton/emit_index_automaton.hpp"

namespace restrip::generator::indices {
namespace {

TEST(IndexAutomaton, ClassesCountedBefore) {
  const Automaton indices = make_automaton({3, 1, 0});
  EXPECT_EQ(indices.undropped, 1436U);
  EXPECT_LT(indices.classes.size(), 480U);
  EXPECT_EQ(make_automaton({1, 0, 0}).undropped, 67U);
}

// Without dropped cases these have no end.
TEST(IndexAutomaton, OtherWeightsCloseWhenCasesAreDropped) {
  for (const Weights weights : {Weights{1, 1, 0}, Weights{2, 1, 0}, Weights{5, 2, 0}}) {
    const Automaton automaton = make_automaton(weights);
    EXPECT_FALSE(automaton.undropped.has_value());
    EXPECT_LT(automaton.classes.size(), 1000U);
  }
}

TEST(IndexAutomaton, CommonFactorsDoNotMatter) {
  const Automaton one = make_automaton({3, 1, 1});
  const Automaton two = make_automaton({6, 2, 2});
  ASSERT_EQ(one.classes.size(), two.classes.size());
  for (std::size_t c = 0; c < one.classes.size(); ++c)
    for (Case k = 0; k < case_codes; ++k) {
      ASSERT_EQ(one.classes[c].costs[k].has_value(), two.classes[c].costs[k].has_value());
      if (one.classes[c].costs[k]) {
        ASSERT_EQ(2 * *one.classes[c].costs[k], *two.classes[c].costs[k]);
      }
    }
}

TEST(IndexAutomaton, WitnessesLeadToTheirClasses) {
  const Automaton automaton = make_automaton({});
  std::set<std::string> witnesses;
  for (std::size_t c = 0; c < automaton.classes.size(); ++c) {
    std::size_t at = 0;
    for (const char letter : automaton.classes[c].witness)
      at = automaton.classes[at].steps[std::string("dslrSLR").find(letter)].to;
    EXPECT_EQ(at, c);
    EXPECT_TRUE(witnesses.insert(automaton.classes[c].witness).second);
  }
}

TEST(IndexAutomaton, RefusesWeightsThatItCannotServe) {
  const auto refusal = [](const Weights& weights) -> std::string {
    try {
      return automaton_header(make_automaton(weights)).text;
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
  };
  EXPECT_NE(refusal({15, 1, 0}).find("need more than 9362 classes of arcs; divide them by a common factor"),
            std::string::npos);
  EXPECT_NE(refusal({0, 1, 0}).find("the weight of a strip is 0; it must be from 1 to 1000"), std::string::npos);
  EXPECT_NE(refusal({3, -1, 0}).find("the weight of a swap is -1"), std::string::npos);
  EXPECT_NE(refusal({3, 1, 1001}).find("the weight of an isolated triangle is 1001"), std::string::npos);
  EXPECT_NE(refusal({300, 100, 0}).find("does not fit its header: a cost of 500"), std::string::npos);
}

TEST(IndexAutomaton, TextsAreTheSameEachTime) {
  EXPECT_EQ(automaton_header(make_automaton({})).text, automaton_header(make_automaton({})).text);
  EXPECT_EQ(automaton_certificate(make_automaton({})).text, automaton_certificate(make_automaton({})).text);
}

}  // namespace
}  // namespace restrip::generator::indices
