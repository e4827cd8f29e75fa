// Claim: the verifier notices what is wrong with the index automaton's certificate. As in rejects_test.cpp: the shipped
// certificate is altered in one row, or made by a careless generator, and each must fail the claim that it breaks.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "altered_certificate.hpp"
#include "turn_certificate.hpp"
#include "turn_check.hpp"

namespace restrip::verify {
namespace {

using namespace test;

const std::vector<std::string>& shipped_index() {
  static const std::vector<std::string> lines =
      lines_of(std::string(RESTRIP_TABLES_DIR) + "/certificates/index-automaton.cert");
  return lines;
}

/// With one pair of arcs in a hundred, spread over all, unless a test needs all.
std::string verdict_with(const std::vector<std::string>& lines, unsigned every) {
  try {
    const TurnCertificate certificate = parse_turn_automaton("altered.cert", text_of(lines));
    const TurnCheck check(certificate, every);
    for (const AutomatonClaim& claim : check.claims())
      if (claim.failures.count != 0) return claim.failures.first;
    return {};
  } catch (const InputError& error) {
    return error.what();
  }
}
std::string index_verdict(const std::vector<std::string>& lines) { return verdict_with(lines, 100); }

void expect_index_noticed(const std::string& kind, const Change& change, const std::string& message,
                          std::size_t count) {
  expect_each_noticed(shipped_index(), index_verdict, kind, change, message, count);
}

TEST(IndexRejects, NothingInTheShippedCertificate) { EXPECT_EQ(index_verdict(shipped_index()), ""); }

TEST(IndexRejects, WrongValues) { expect_index_noticed("value", one_more(3), "wrong", 5); }

TEST(IndexRejects, WrongCosts) { expect_index_noticed("step", one_more(4), "wrong cost", 5); }

TEST(IndexRejects, WrongSteps) { expect_index_noticed("step", one_more(3), "altered.cert:", 5); }

TEST(IndexRejects, WrongOrigins) {
  const Change other = [](std::vector<std::string> words) -> std::optional<std::string> {
    if (words[4] == "--" || words[4] == "tt") return {};
    words[4] = words[4] == "ff" ? "qq" : "ff";
    return joined(words);
  };
  expect_index_noticed("from", other, "wrong origin", 5);
}

TEST(IndexRejects, WrongWitnesses) {
  const Change longer = [](std::vector<std::string> words) -> std::optional<std::string> {
    if (words[2] == "-") return {};
    words[2].insert(words[2].begin(), 'd');
    return joined(words);
  };
  expect_index_noticed("class", longer, "wrong witness", 5);
}

/// Another cost than that of the rows.
TEST(IndexRejects, WrongWeights) {
  expect_index_noticed("weights", one_more(1), "altered.cert:", 1);
  expect_index_noticed("weights", one_more(2), "altered.cert:", 1);
  expect_index_noticed("weights", one_more(3), "altered.cert:", 1);
}

TEST(IndexRejects, CasesThatAreNeededAndMissing) {
  const std::string verdict = verdict_with(without_left_links(shipped_index()), 100);
  EXPECT_NE(verdict.find("missing case"), std::string::npos) << verdict;
}

TEST(IndexRejects, MalformedFiles) {
  const auto row_of = [&](const std::string& start) {
    for (std::size_t i = 0; i < shipped_index().size(); ++i)
      if (shipped_index()[i].rfind(start, 0) == 0) return i;
    ADD_FAILURE() << "no row " << start;
    return std::size_t{0};
  };
  const auto without = [&](const std::string& start) {
    std::vector<std::string> lines = shipped_index();
    lines.erase(lines.begin() + static_cast<std::ptrdiff_t>(row_of(start)));
    return index_verdict(lines);
  };
  const auto with = [&](const std::string& start, const std::string& line) {
    std::vector<std::string> lines = shipped_index();
    lines[row_of(start)] = line;
    return index_verdict(lines);
  };
  EXPECT_NE(without("class 5 ").find("there is no class"), std::string::npos);
  EXPECT_NE(without("value 7 -- ").find("expected the value of case -- of class 7"), std::string::npos);
  EXPECT_NE(without("step 3 s ").find("expected the letter d, found \"s\""), std::string::npos);
  EXPECT_NE(without("from 3 s ").find("for each case"), std::string::npos);
  EXPECT_NE(without("weights ").find("altered.cert:"), std::string::npos);
  EXPECT_NE(without("section classes").find("altered.cert:"), std::string::npos);
  EXPECT_NE(without("claim rows").find("claim rows missing"), std::string::npos);
  EXPECT_NE(with("value 2 ", "value 2 xy 0").find("is no case"), std::string::npos);
  EXPECT_NE(with("value 2 ", "value 2 -- -1").find("expected a number from 0"), std::string::npos);
  EXPECT_NE(with("class 2 ", "class 2 sxs").find("is no witness"), std::string::npos);
  EXPECT_NE(with("step 0 d ", "step 0 d 9999 0").find("there is no class 9999"), std::string::npos);
  EXPECT_NE(with("weights ", "weights 0 1 0").find("expected a number from 1 to 1000"), std::string::npos);
  EXPECT_NE(with("family ", "family automaton").find("expected"), std::string::npos);
  std::string bytes = text_of(shipped_index());
  bytes.resize(bytes.size() / 2);
  EXPECT_THROW(parse_turn_automaton("half.cert", bytes), InputError);
  bytes = text_of(shipped_index());
  bytes[bytes.size() / 3] = bytes[bytes.size() / 3] == '1' ? '2' : '1';
  EXPECT_THROW(parse_turn_automaton("altered.cert", bytes), InputError);
}

}  // namespace
}  // namespace restrip::verify
