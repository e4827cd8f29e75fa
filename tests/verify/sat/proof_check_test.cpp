// The proof checker: right proofs, wrong ones, malformed ones, each named for its crime; and a plainer checker that
// must say the same of every proof with a line cut out or a literal turned round.
#include "sat/proof_check.hpp"

#include <gtest/gtest.h>

#include <random>

#include "model/input.hpp"
#include "naive_rup.hpp"

namespace restrip::verify::sat::test {
namespace {

/// Every clause over three variables: contradictory, and not by unit propagation alone.
const std::string all_of_three =
    "c every clause over three variables\np cnf 3 8\n"
    "1 2 3 0\n1 2 -3 0\n1 -2 3 0\n1 -2 -3 0\n-1 2 3 0\n-1 2 -3 0\n-1 -2 3 0\n-1 -2 -3 0\n";
/// The same without the last.
const std::string satisfiable = "p cnf 3 7\n1 2 3 0\n1 2 -3 0\n1 -2 3 0\n1 -2 -3 0\n-1 2 3 0\n-1 2 -3 0\n-1 -2 3 0\n";

ProofVerdict verdict_of(const std::string& formula, const std::string& proof) {
  const Cnf cnf = parse_dimacs("formula", formula);
  return check_proof(cnf, parse_proof("proof", proof, cnf.variables));
}

struct Case {
  const char* name;
  std::string formula;
  std::string proof;
  const char* says = "";
};

TEST(ProofCheck, AcceptsRightProofs) {
  const Case cases[] = {
      {"plain", all_of_three, "1 2 0\n1 0\n2 0\n0\n"},
      {"literals in any order", all_of_three, "2 1 0\n1 0\n2 0\n0\n"},
      {"deletions of what is no longer needed", all_of_three, "1 2 0\nd 3 1 2 0\nd 1 2 -3 0\n1 0\nd 2 1 0\n2 0\n0\n"},
      {"a literal twice", all_of_three, "1 2 2 1 0\nd 2 1 0\n1 2 0\n1 0\n2 0\n0\n"},
      {"a clause with a literal and its negation", all_of_three, "1 -1 0\nd 1 -1 0\n1 2 0\n1 0\n2 0\n0\n"},
      {"one of two copies deleted", all_of_three, "1 2 0\n1 2 0\nd 1 2 0\n1 0\n2 0\n0\n"},
      {"steps behind the empty clause", all_of_three, "1 2 0\n1 0\n2 0\n0\nd 1 0\n"},
      {"the formula contains the empty clause", "p cnf 1 1\n0\n", "0\n"},
      {"unit propagation alone", "p cnf 2 3\n1 0\n-1 2 0\n-2 0\n", "0\n"},
      {"no variable at all", "p cnf 0 1\n0\n", "0\n"},
  };
  for (const Case& c : cases) {
    const ProofVerdict verdict = verdict_of(c.formula, c.proof);
    EXPECT_TRUE(verdict.proved) << c.name << ": " << verdict.fault;
    EXPECT_EQ(verdict.fault, "") << c.name;
  }
}

TEST(ProofCheck, RefusesWrongProofs) {
  const char* const not_implied = "does not follow";
  const Case cases[] = {
      {"empty file", all_of_three, "", "the empty clause is missing"},
      {"no empty clause", all_of_three, "1 2 0\n1 0\n2 0\n", "the empty clause is missing"},
      {"only the empty clause", all_of_three, "0\n", "line 1: does not follow"},
      {"a line missing", all_of_three, "1 0\n2 0\n0\n", "line 1: does not follow"},
      {"a wrong literal", all_of_three, "1 2 0\n-1 0\n2 0\n0\n", "line 2: does not follow"},
      {"the empty clause too early", all_of_three, "1 2 0\n0\n1 0\n2 0\n", "line 2: does not follow"},
      {"a formula that has a model", satisfiable, "1 2 0\n1 0\n2 0\n0\n", "line 4: does not follow"},
      {"a needed clause deleted", all_of_three, "d 1 2 3 0\n1 2 0\n1 0\n2 0\n0\n", "line 2: does not follow"},
      {"a needed unit deleted", all_of_three, "1 2 0\n1 0\nd 1 0\n2 0\n0\n", "line 5: does not follow"},
      {"the clause that fixes a literal deleted", "p cnf 2 3\n1 0\n-1 2 0\n-1 -2 0\n", "d 1 0\n0\n",
       "line 2: does not follow"},
      {"deletes what is not there", all_of_three, "d 1 2 0\n1 2 0\n1 0\n2 0\n0\n",
       "line 1: deletes a clause that is not there"},
      {"deletes twice", all_of_three, "d 1 2 3 0\nd 1 2 3 0\n0\n", "line 2: deletes a clause that is not there"},
      {"deletes the empty clause", all_of_three, "d 0\n0\n", "line 1: deletes a clause that is not there"},
      // Resolution asymmetric tautologies are right DRAT steps; this checker does not know them.
      {"RAT", "p cnf 2 2\n1 2 0\n-1 2 0\n", "-2 0\n0\n", not_implied},
  };
  for (const Case& c : cases) {
    const ProofVerdict verdict = verdict_of(c.formula, c.proof);
    EXPECT_FALSE(verdict.proved) << c.name;
    EXPECT_NE(verdict.fault.find(c.says), std::string::npos) << c.name << ": " << verdict.fault;
  }
}

TEST(ProofCheck, RefusesMalformedFiles) {
  const Case cases[] = {
      {"garbage", all_of_three, "hello\n", "proof:1: expected numbers and a closing 0"},
      {"binary", all_of_three, std::string("a\x04\x06\0", 4) + "\n", "proof:1: expected numbers and a closing 0"},
      {"no closing 0", all_of_three, "1 2\n", "proof:1: expected numbers and a closing 0"},
      {"cut off", all_of_three, "1 2 0\n1 0", "proof:2: the file ends in the middle of a line"},
      {"more behind the 0", all_of_three, "1 2 0 3 0\n", "proof:1: expected the end of the line after the 0"},
      {"blank line", all_of_three, "1 2 0\n\n", "proof:2: expected numbers and a closing 0"},
      {"foreign variable", all_of_three, "1 2 0\n4 0\n", "proof:2: there is no variable 4; the formula has 3"},
      {"a number too large", all_of_three, "99999999999 0\n", "proof:1: expected numbers and a closing 0"},
      {"the smallest number", all_of_three, "-2147483648 0\n", "proof:1: "},
      {"delete without a space", all_of_three, "d1 0\n", "proof:1: expected numbers and a closing 0"},
      {"formula without header", "1 0\n", "0\n", "formula:1: expected \"p cnf VARIABLES CLAUSES\""},
      {"formula with half a header", "p cnf 3\n", "0\n", "formula:1: expected \"p cnf VARIABLES CLAUSES\""},
      {"a clause missing", "p cnf 1 2\n1 0\n", "0\n", "formula:2: 2 clauses announced, 1 found"},
      {"formula cut off", "p cnf 1 1\n1 ", "0\n", "formula:2: the file ends in the middle of a line"},
      {"formula empty", "", "0\n", "formula:1: "},
      {"foreign variable in the formula", "p cnf 1 1\n2 0\n", "0\n", "formula:2: there is no variable 2"},
  };
  for (const Case& c : cases) {
    try {
      verdict_of(c.formula, c.proof);
      ADD_FAILURE() << c.name << ": no error";
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(c.says), std::string::npos) << c.name << ": " << error.what();
    }
  }
}

TEST(ProofCheck, TheCoreIsWhatTheEmptyClauseRestsOn) {
  // Lines 1 and 4 are right, and useless: nothing makes variable 4 false.
  const std::string formula = "p cnf 4 9\n" + all_of_three.substr(all_of_three.find("1 2 3 0")) + "4 1 0\n";
  const ProofVerdict verdict = verdict_of(formula, "4 1 2 0\n1 2 0\n1 0\n4 -3 1 0\n2 0\n0\n");
  ASSERT_TRUE(verdict.proved);
  EXPECT_EQ(verdict.core, (std::vector<std::size_t>{1, 2, 4, 5}));
}

/// Random formulas over few variables with resolution-like random lemmas: many right, many wrong.
TEST(ProofCheck, AgreesWithPlainPropagationOnRandomProofs) {
  std::mt19937 random(20240607);
  const auto below = [&](unsigned n) { return static_cast<int>(random() % n); };
  const auto random_clause = [&](int shortest) {
    Clause clause;
    for (int i = shortest + below(2); i > 0; --i) clause.push_back((below(5) + 1) * (below(2) == 0 ? 1 : -1));
    return clause;
  };
  std::size_t right = 0;
  std::size_t wrong = 0;
  for (int round = 0; round < 6000; ++round) {
    Cnf cnf{5, {}};
    for (int i = 0; i < 24; ++i) cnf.clauses.push_back(random_clause(2));
    Proof proof;
    std::vector<Clause> there = cnf.clauses;
    for (int i = below(6); i > 0; --i) {
      const bool deletes = below(2) == 0;
      proof.push_back({deletes, deletes ? there[static_cast<std::size_t>(below(24))] : random_clause(1), 0});
    }
    proof.push_back({false, {}, 0});
    const bool expected = naively_proved(cnf, proof);
    ++(expected ? right : wrong);
    ASSERT_EQ(check_proof(cnf, proof).proved, expected) << "round " << round;
  }
  EXPECT_GT(right, 500U);
  EXPECT_GT(wrong, 500U);
}

}  // namespace
}  // namespace restrip::verify::sat::test
