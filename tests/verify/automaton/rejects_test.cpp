// Claim: the automaton's verifier notices faults. One row of the shipped certificate is altered and its sums are
// updated. Each alteration must fail the claim that it breaks, or be refused as malformed. Rows of each kind are
// altered at a fixed stride, so that no row is chosen because it is known to be noticed.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "automaton/automaton_certificate.hpp"
#include "automaton/class_check.hpp"
#include "certificate/certificate_form.hpp"
#include "model/input.hpp"

namespace restrip::verify::test {
namespace {

/// The parts between these characters: lines, including the empty one after the last line break, or words.
std::vector<std::string> parts_of(const std::string& text, char between) {
  std::vector<std::string> parts(1);
  for (const char c : text)
    if (c == between)
      parts.emplace_back();
    else
      parts.back() += c;
  return parts;
}

/// The words of a line, and a line of words.
std::vector<std::string> words_of(const std::string& line) { return parts_of(line, ' '); }
std::string joined(const std::vector<std::string>& words) { return fmt::format("{}", fmt::join(words, " ")); }

/// The text with the right last line. Everything outside the frame is a row.
std::string sealed_again(const std::vector<std::string>& lines) {
  std::string text;
  std::size_t rows = 0;
  for (std::size_t i = 0; i + 2 < lines.size(); ++i) {
    text += lines[i] + "\n";
    const std::string word = words_of(lines[i])[0];
    rows += word != "restrip-certificate" && word != "family" && word != "section" && word != "claim";
  }
  const ByteSums sums = sums_of(text);
  return text + fmt::format("end {} {} {}\n", rows, sums.plain, sums.weighted);
}

/// The checker's first message; empty if all claims hold.
std::string verdict_of(const std::string& text) {
  try {
    const AutomatonCertificate certificate = parse_automaton("altered.cert", text);
    const ClassCheck check = check_classes(certificate);
    for (const AutomatonClaim& claim : check.claims)
      if (claim.failures.count != 0) return claim.failures.first;
    return {};
  } catch (const InputError& error) {
    return error.what();
  }
}

/// A change of one row; empty if it does not apply to this row.
using RowChange = std::function<std::optional<std::string>(std::vector<std::string> words)>;

/// The word at this index, plus one.
RowChange one_more(std::size_t word) {
  return [word](std::vector<std::string> words) {
    words[word] = std::to_string(std::stoi(words[word]) + 1);
    return joined(words);
  };
}

class AutomatonRejects : public testing::Test {
 protected:
  const std::vector<std::string>& good() const {
    static const std::vector<std::string> lines =
        parts_of(read_file(RESTRIP_TABLES_DIR "/certificates/automaton.cert"), '\n');
    return lines;
  }

  /// Changes `count` rows of a kind, one at a time, spread over the file; each must be noticed.
  void expect_noticed(const std::string& kind, const RowChange& change, const std::string& message,
                      std::size_t count = 1) const {
    std::vector<std::size_t> rows;
    for (std::size_t i = 0; i < good().size(); ++i)
      if (good()[i].rfind(kind + " ", 0) == 0 && change(words_of(good()[i]))) rows.push_back(i);
    ASSERT_GE(rows.size(), count) << kind;
    for (std::size_t n = 0; n < count; ++n) {
      const std::size_t row = rows[(2 * n + 1) * rows.size() / (2 * count)];
      std::vector<std::string> lines = good();
      lines[row] = change(words_of(lines[row])).value();
      const std::string verdict = verdict_of(sealed_again(lines));
      EXPECT_NE(verdict.find(message), std::string::npos) << good()[row] << " -> " << lines[row] << ": " << verdict;
    }
  }
};

TEST_F(AutomatonRejects, NothingInAGoodCertificate) { EXPECT_EQ(verdict_of(sealed_again(good())), ""); }

/// A cost that differs from the rows.
TEST_F(AutomatonRejects, WrongWeights) {
  expect_noticed("weights", one_more(1), "altered.cert:");
  expect_noticed("weights", one_more(2), "altered.cert:");
  expect_noticed("weights", one_more(3), "altered.cert:");
}

TEST_F(AutomatonRejects, WrongValues) {
  const RowChange of_several = [](std::vector<std::string> words) -> std::optional<std::string> {
    if (words[2] == "--") return {};
    return one_more(3)(words);
  };
  expect_noticed("value", of_several, "wrong", 2);
}

TEST_F(AutomatonRejects, WrongCosts) { expect_noticed("step", one_more(4), "wrong cost"); }

TEST_F(AutomatonRejects, WrongSteps) { expect_noticed("step", one_more(3), "altered.cert:", 2); }

TEST_F(AutomatonRejects, WrongOrigins) {
  const RowChange other = [](std::vector<std::string> words) -> std::optional<std::string> {
    if (words[4] == "--" || words[4] == "tt") return {};
    words[4] = words[4] == "ee" ? "pp" : "ee";
    return joined(words);
  };
  expect_noticed("from", other, "wrong origin");
}

TEST_F(AutomatonRejects, UnsoundClosings) {
  const RowChange cycle = [](std::vector<std::string> words) {
    words[2] = "tt";
    return joined(words);
  };
  expect_noticed("close", cycle, "unsound closing");
}

TEST_F(AutomatonRejects, InferiorClosings) {
  const RowChange all_dashed = [](std::vector<std::string> words) -> std::optional<std::string> {
    if (words[2] == "--") return {};
    words[2] = "--";
    return joined(words);
  };
  expect_noticed("close", all_dashed, " closing");
}

TEST_F(AutomatonRejects, InferiorMeetings) {
  const RowChange all_dashed = [](std::vector<std::string> words) -> std::optional<std::string> {
    if (words[3] == "--" || words[4] == "--") return {};
    words[3] = words[4] = "--";
    words[5] = "-";
    return joined(words);
  };
  expect_noticed("meet", all_dashed, " meeting");
  // A and D keep a solid edge each: dropping the chord leaves only worse meetings.
  const RowChange without_chord = [](std::vector<std::string> words) -> std::optional<std::string> {
    const bool edge_at_a = words[3][0] != '-' || words[4][1] != '-';
    const bool edge_at_d = words[3][1] != '-' || words[4][0] != '-';
    if (words[5] != "chord" || !edge_at_a || !edge_at_d) return {};
    words[5] = "-";
    return joined(words);
  };
  expect_noticed("meet", without_chord, " meeting", 4);
}

TEST_F(AutomatonRejects, UnsoundMeetings) {
  const RowChange three_edges = [](std::vector<std::string> words) -> std::optional<std::string> {
    const bool three_at_a = words[3][0] != '-' && words[4][1] != '-';
    if (!three_at_a || words[5] == "chord") return {};
    words[5] = "chord";
    return joined(words);
  };
  expect_noticed("meet", three_edges, "unsound meeting");
}

TEST_F(AutomatonRejects, WrongWitnesses) {
  const RowChange longer = [](std::vector<std::string> words) -> std::optional<std::string> {
    if (words[2] == "-") return {};
    words[2].insert(words[2].begin(), 'd');
    return joined(words);
  };
  expect_noticed("class", longer, "wrong witness");
}

/// Another row or column of meetings.
TEST_F(AutomatonRejects, WrongRowsAndColumns) {
  for (const std::size_t word : {3U, 4U}) {
    const RowChange first_one = [word](std::vector<std::string> words) -> std::optional<std::string> {
      if (words[word] == "-" || std::stoi(words[word]) < 5) return {};
      words[word] = "0";
      return joined(words);
    };
    expect_noticed("class", first_one, "altered.cert:");
  }
}

/// Malformed files: no claim is checked.
TEST_F(AutomatonRejects, MalformedFiles) {
  const auto row_of = [&](const std::string& start) {
    for (std::size_t i = 0; i < good().size(); ++i)
      if (good()[i].rfind(start, 0) == 0) return i;
    ADD_FAILURE() << "no row " << start;
    return std::size_t{0};
  };
  const auto without = [&](const std::string& start) {
    std::vector<std::string> lines = good();
    lines.erase(lines.begin() + static_cast<std::ptrdiff_t>(row_of(start)));
    return verdict_of(sealed_again(lines));
  };
  const auto with = [&](const std::string& start, const std::string& line) {
    std::vector<std::string> lines = good();
    lines[row_of(start)] = line;
    return verdict_of(sealed_again(lines));
  };
  EXPECT_NE(without("weights ").find("altered.cert:"), std::string::npos);
  EXPECT_NE(without("class 5 ").find("does not exist"), std::string::npos);
  EXPECT_NE(without("value 7 ").find("altered.cert:"), std::string::npos);
  EXPECT_NE(without("step 3 s ").find("expected the letter d, found \"s\""), std::string::npos);
  EXPECT_NE(without("from 3 s ").find("for each case"), std::string::npos);
  EXPECT_NE(without("close 5 ").find("expected 5, found"), std::string::npos);
  EXPECT_NE(without("meet 2 9 ").find("expected 9, found 10"), std::string::npos);
  EXPECT_NE(without("section meetings").find("expected"), std::string::npos);
  EXPECT_NE(without("claim rows").find("claim rows missing"), std::string::npos);
  EXPECT_NE(with("weights ", "weights 1000 1 1").find("expected 0, found 1"), std::string::npos);
  EXPECT_NE(with("weights ", "weights 3 0 1").find("expected 1000, found 3"), std::string::npos);
  EXPECT_NE(with("close 2 ", "close 2 xy").find("is not a case"), std::string::npos);
  EXPECT_NE(with("meet 2 9 ", "meet 2 9 -- -- cord").find("expected \"chord\" or \"-\""), std::string::npos);
  EXPECT_NE(with("class 2 ", "class 2 sxs 1 1").find("is not a witness"), std::string::npos);
  EXPECT_NE(with("class 2 ", "class 2 s - 1").find("expected"), std::string::npos);
  EXPECT_NE(with("class 2 ", "class 2 s 70 1").find("expected a number from 0 to 1"), std::string::npos);
  EXPECT_NE(with("step 0 d ", "step 0 d 65000 0").find("class 65000 does not exist"), std::string::npos);
  EXPECT_NE(with("value 1 --", "value 1 -- -1").find("expected a number from 0"), std::string::npos);
  EXPECT_NE(with("family ", "family split").find("expected"), std::string::npos);
  std::string bytes = sealed_again(good());
  bytes.resize(bytes.size() / 2);
  EXPECT_THROW(parse_automaton("half.cert", bytes), InputError);
  bytes = sealed_again(good());
  bytes[bytes.size() / 3] = bytes[bytes.size() / 3] == '1' ? '2' : '1';
  EXPECT_THROW(parse_automaton("altered.cert", bytes), InputError);
}

}  // namespace
}  // namespace restrip::verify::test
