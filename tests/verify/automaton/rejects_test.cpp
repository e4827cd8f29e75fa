// Claim: the automaton's verifier notices what is wrong. The shipped certificate is altered in one row, its sums
// brought up to date, and each alteration must fail the claim that it breaks, or be refused as not well formed. Kinds
// of rows are altered wherever a fixed stride meets them, so that no row is picked because it is known to be noticed.
#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

#include "altered_certificate.hpp"
#include "automaton_certificate.hpp"
#include "class_check.hpp"
#include "input.hpp"

namespace restrip::verify {
namespace {

using namespace test;

const std::vector<std::string>& shipped() {
  static const std::vector<std::string> lines =
      lines_of(std::string(RESTRIP_TABLES_DIR) + "/certificates/automaton.cert");
  return lines;
}

/// What the checker says first; empty when all claims hold.
std::string verdict_of(const std::vector<std::string>& lines) {
  try {
    const AutomatonCertificate certificate = parse_automaton("altered.cert", text_of(lines));
    const ClassCheck check(certificate);
    for (const AutomatonClaim& claim : check.claims())
      if (claim.failures.count != 0) return claim.failures.first;
    return {};
  } catch (const InputError& error) {
    return error.what();
  }
}

void expect_noticed(const std::string& kind, const Change& change, const std::string& message, std::size_t count) {
  expect_each_noticed(shipped(), verdict_of, kind, change, message, count);
}

TEST(AutomatonRejects, NothingInTheShippedCertificate) { EXPECT_EQ(verdict_of(shipped()), ""); }

TEST(AutomatonRejects, WrongValues) {
  const Change of_several = [](std::vector<std::string> words) -> std::optional<std::string> {
    if (words[2] == "--") return {};
    return one_more(3)(words);
  };
  expect_noticed("value", of_several, "wrong", 1);
}

TEST(AutomatonRejects, WrongGains) { expect_noticed("step", one_more(4), "wrong gain", 1); }

TEST(AutomatonRejects, WrongSteps) { expect_noticed("step", one_more(3), "altered.cert:", 2); }

TEST(AutomatonRejects, WrongOrigins) {
  const Change to_dashed = [](std::vector<std::string> words) -> std::optional<std::string> {
    if (words[4] == "--" || words[4] == "tt") return {};
    words[4] = words[4] == "ee" ? "pp" : "ee";
    return joined(words);
  };
  expect_noticed("from", to_dashed, "wrong origin", 1);
}

TEST(AutomatonRejects, WrongClosings) { expect_noticed("close", one_more(3), "wrong value: the closing", 1); }

TEST(AutomatonRejects, UnsoundClosings) {
  const Change cycle = [](std::vector<std::string> words) {
    words[2] = "tt";
    return joined(words);
  };
  expect_noticed("close", cycle, "unsound closing", 1);
}

TEST(AutomatonRejects, WrongMeetings) { expect_noticed("meet", one_more(7), "wrong value: the meeting", 1); }

TEST(AutomatonRejects, InferiorMeetings) {
  const Change all_dashed = [](std::vector<std::string> words) -> std::optional<std::string> {
    if (words[3] == "--" || words[4] == "--") return {};
    words[3] = words[4] = "--";
    words[5] = "-";
    return joined(words);
  };
  expect_noticed("meet", all_dashed, " meeting", 1);
}

TEST(AutomatonRejects, UnsoundMeetings) {
  const Change three_edges = [](std::vector<std::string> words) -> std::optional<std::string> {
    if (words[3] != "tt" || words[5] == "chord") return {};
    words[5] = "chord";
    return joined(words);
  };
  expect_noticed("meet", three_edges, "unsound meeting", 1);
}

TEST(AutomatonRejects, WrongWitnesses) {
  const Change longer = [](std::vector<std::string> words) -> std::optional<std::string> {
    if (words[2] == "-") return {};
    words[2].insert(words[2].begin(), 'd');
    return joined(words);
  };
  expect_noticed("class", longer, "wrong witness", 1);
}

/// Files that are not well formed: no claim is looked at.
TEST(AutomatonRejects, MalformedFiles) {
  const auto row_of = [&](const std::string& start) {
    for (std::size_t i = 0; i < shipped().size(); ++i)
      if (shipped()[i].rfind(start, 0) == 0) return i;
    ADD_FAILURE() << "no row " << start;
    return std::size_t{0};
  };
  const auto without = [&](const std::string& start) {
    std::vector<std::string> lines = shipped();
    lines.erase(lines.begin() + static_cast<std::ptrdiff_t>(row_of(start)));
    return verdict_of(lines);
  };
  const auto with = [&](const std::string& start, const std::string& line) {
    std::vector<std::string> lines = shipped();
    lines[row_of(start)] = line;
    return verdict_of(lines);
  };
  EXPECT_NE(without("class 5 ").find("there is no class"), std::string::npos);
  EXPECT_NE(without("value 7 ").find("altered.cert:"), std::string::npos);
  EXPECT_NE(without("step 3 s ").find("expected the letter d, found \"s\""), std::string::npos);
  EXPECT_NE(without("from 3 s ").find("for each case"), std::string::npos);
  EXPECT_NE(without("close 5 ").find("expected 5, found"), std::string::npos);
  EXPECT_NE(without("meet 2 9 ").find("expected 9, found 10"), std::string::npos);
  EXPECT_NE(without("section meetings").find("expected"), std::string::npos);
  EXPECT_NE(without("claim rows").find("claim rows missing"), std::string::npos);
  EXPECT_NE(with("close 2 ", "close 2 xy 0 0").find("is no case"), std::string::npos);
  EXPECT_NE(with("meet 2 9 ", "meet 2 9 -- -- cord 0 0").find("expected \"chord\" or \"-\""), std::string::npos);
  EXPECT_NE(with("class 2 ", "class 2 sxs").find("is no witness"), std::string::npos);
  EXPECT_NE(with("step 0 d ", "step 0 d 254 0 0").find("there is no class 254"), std::string::npos);
  EXPECT_NE(with("family ", "family split").find("expected"), std::string::npos);
  std::string bytes = text_of(shipped());
  bytes.resize(bytes.size() / 2);
  EXPECT_THROW(parse_automaton("half.cert", bytes), InputError);
  bytes = text_of(shipped());
  bytes[bytes.size() / 3] = bytes[bytes.size() / 3] == '1' ? '2' : '1';
  EXPECT_THROW(parse_automaton("altered.cert", bytes), InputError);
}

}  // namespace
}  // namespace restrip::verify
