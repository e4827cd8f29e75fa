// Claim: the automaton's verifier notices faults. One row of the shipped certificate is altered and its sums are
// updated. Each alteration must fail the claim that it breaks, or be refused as malformed. Rows of each kind are
// altered at a fixed stride, so that no row is chosen because it is known to be noticed.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "automaton/automaton_certificate.hpp"
#include "automaton/class_check.hpp"
#include "certificate/certificate.hpp"
#include "model/input.hpp"

namespace restrip::verify::test {
namespace {

using Words = std::vector<std::string>;

/// The parts between these characters: lines, including the empty one after the last line break, or words.
Words parts_of(const std::string& text, char between) {
  Words parts(1);
  for (const char c : text)
    if (c == between)
      parts.emplace_back();
    else
      parts.back() += c;
  return parts;
}

/// The text with the right last line. Everything outside the frame is a row.
std::string sealed_again(const Words& lines) {
  std::string text;
  std::size_t rows = 0;
  for (std::size_t i = 0; i + 2 < lines.size(); ++i) {
    text += lines[i] + "\n";
    const std::string word = parts_of(lines[i], ' ')[0];
    rows += word != "restrip-certificate" && word != "family" && word != "section" && word != "claim";
  }
  const ByteSums sums = sums_of(text);
  return text + fmt::format("end {} {} {}\n", rows, sums.plain, sums.weighted);
}

/// The checker's first message; empty if all claims hold.
std::string first_message_of(const std::string& text) {
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

/// Changes the words of a row; false if the change does not apply to it.
using RowChange = std::function<bool(Words&)>;

/// The word at this index, plus one.
RowChange one_more(std::size_t word) {
  return [word](Words& words) {
    words[word] = std::to_string(std::stoi(words[word]) + 1);
    return true;
  };
}

class AutomatonRejects : public testing::Test {
 protected:
  const Words& good() const {
    static const Words lines = parts_of(read_file(RESTRIP_TABLES_DIR "/certificates/automaton.cert"), '\n');
    return lines;
  }

  /// Changes `count` rows of a kind, one at a time, spread over the file; each must be noticed.
  void expect_noticed(const std::string& kind, const RowChange& change, const std::string& message,
                      std::size_t count = 1) const {
    std::vector<std::pair<std::size_t, std::string>> rows;
    for (std::size_t i = 0; i < good().size(); ++i)
      if (Words words = parts_of(good()[i], ' '); words[0] == kind && change(words))
        rows.emplace_back(i, fmt::format("{}", fmt::join(words, " ")));
    ASSERT_GE(rows.size(), count) << kind;
    for (std::size_t n = 0; n < count; ++n) {
      const auto& [row, line] = rows[(2 * n + 1) * rows.size() / (2 * count)];
      Words lines = good();
      lines[row] = line;
      const std::string verdict = first_message_of(sealed_again(lines));
      EXPECT_NE(verdict.find(message), std::string::npos) << good()[row] << " -> " << line << ": " << verdict;
    }
  }
};

TEST_F(AutomatonRejects, NothingInAGoodCertificate) { EXPECT_EQ(first_message_of(sealed_again(good())), ""); }

/// A cost that differs from the rows.
TEST_F(AutomatonRejects, WrongWeights) {
  for (const std::size_t word : {1U, 2U, 3U}) expect_noticed("weights", one_more(word), "altered.cert:");
}

TEST_F(AutomatonRejects, WrongValues) {
  const auto of_several = [](Words& words) { return words[2] != "--" && one_more(3)(words); };
  expect_noticed("value", of_several, "wrong", 2);
}

TEST_F(AutomatonRejects, WrongCosts) { expect_noticed("step", one_more(4), "wrong cost"); }

TEST_F(AutomatonRejects, WrongSteps) { expect_noticed("step", one_more(3), "altered.cert:", 2); }

TEST_F(AutomatonRejects, WrongOrigins) {
  const auto other = [](Words& words) {
    if (words[4] == "--" || words[4] == "tt") return false;
    words[4] = words[4] == "ee" ? "pp" : "ee";
    return true;
  };
  expect_noticed("from", other, "wrong origin");
}

TEST_F(AutomatonRejects, UnsoundClosings) {
  const auto cycle = [](Words& words) {
    words[2] = "tt";
    return true;
  };
  expect_noticed("close", cycle, "unsound closing");
}

TEST_F(AutomatonRejects, InferiorClosings) {
  const auto all_dashed = [](Words& words) { return std::exchange(words[2], "--") != "--"; };
  expect_noticed("close", all_dashed, " closing");
}

TEST_F(AutomatonRejects, InferiorMeetings) {
  const auto all_dashed = [](Words& words) {
    if (words[3] == "--" || words[4] == "--") return false;
    words[3] = words[4] = "--";
    words[5] = "-";
    return true;
  };
  expect_noticed("meet", all_dashed, " meeting");
  // A and D keep a solid edge each: dropping the chord leaves only worse meetings.
  const auto without_chord = [](Words& words) {
    const bool edge_at_a = words[3][0] != '-' || words[4][1] != '-';
    const bool edge_at_d = words[3][1] != '-' || words[4][0] != '-';
    return edge_at_a && edge_at_d && std::exchange(words[5], "-") == "chord";
  };
  expect_noticed("meet", without_chord, " meeting", 4);
}

TEST_F(AutomatonRejects, UnsoundMeetings) {
  const auto three_edges = [](Words& words) {
    const bool two_at_a = words[3][0] != '-' && words[4][1] != '-';
    return two_at_a && std::exchange(words[5], "chord") != "chord";
  };
  expect_noticed("meet", three_edges, "unsound meeting");
}

TEST_F(AutomatonRejects, WrongWitnesses) {
  const auto longer = [](Words& words) {
    if (words[2] == "-") return false;
    words[2].insert(words[2].begin(), 'd');
    return true;
  };
  expect_noticed("class", longer, "wrong witness");
}

/// Another row or column of meetings.
TEST_F(AutomatonRejects, WrongRowsAndColumns) {
  for (const std::size_t word : {3U, 4U}) {
    const auto first_one = [word](Words& words) {
      const std::string was = std::exchange(words[word], "0");
      return was != "-" && std::stoi(was) >= 5;
    };
    expect_noticed("class", first_one, "altered.cert:");
  }
}

/// Malformed files: no claim is checked. The first row that begins so is left out or replaced.
TEST_F(AutomatonRejects, MalformedFiles) {
  for (const auto& [start, by, said] : std::vector<std::array<std::string, 3>>{
           {"weights ", "", "altered.cert:"},
           {"class 5 ", "", "does not exist"},
           {"value 7 ", "", "altered.cert:"},
           {"step 3 s ", "", "expected the letter d, found \"s\""},
           {"from 3 s ", "", "for each case"},
           {"from 0 d ", "from 0 d -e --", "in the order of cases"},
           {"close 5 ", "", "expected 5, found"},
           {"meet 2 9 ", "", "expected 9, found 10"},
           {"section meetings", "", "expected"},
           {"claim rows", "", "claim rows missing"},
           {"weights ", "weights 1000 1 1", "expected 0, found 1"},
           {"weights ", "weights 3 0 1", "expected 1000, found 3"},
           {"close 2 ", "close 2 xy", "is not a case"},
           {"meet 2 9 ", "meet 2 9 -- -- cord", "expected \"chord\" or \"-\""},
           {"class 2 ", "class 2 sxs 1 1", "is not a witness"},
           {"class 2 ", "class 2 s - 1", "expected"},
           {"class 2 ", "class 2 s 70 1", "expected a number from 0 to 1"},
           {"step 0 d ", "step 0 d 65000 0", "class 65000 does not exist"},
           {"value 1 --", "value 1 -- -1", "expected a number from 0"},
           {"family ", "family split", "expected"},
       }) {
    Words lines = good();
    const auto row = std::find_if(lines.begin(), lines.end(),
                                  [&begin = start](const std::string& line) { return line.starts_with(begin); });
    ASSERT_NE(row, lines.end()) << start;
    if (by.empty())
      lines.erase(row);
    else
      *row = by;
    const std::string verdict = first_message_of(sealed_again(lines));
    EXPECT_NE(verdict.find(said), std::string::npos) << start << " -> " << by << ": " << verdict;
  }
  const std::string bytes = sealed_again(good());
  EXPECT_THROW(parse_automaton("half.cert", bytes.substr(0, bytes.size() / 2)), InputError);
  std::string altered = bytes;
  altered[bytes.size() / 3] = altered[bytes.size() / 3] == '1' ? '2' : '1';
  EXPECT_THROW(parse_automaton("altered.cert", altered), InputError);
}

}  // namespace
}  // namespace restrip::verify::test
