// Certificates altered in a way that breaks one claim are refused; the good ones are not: the shipped one, and one of a
// cost in which swaps have a price.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "altered_lines.hpp"
#include "automaton/automaton_certificate.hpp"
#include "automaton/class_check.hpp"
#include "automaton/fan_check.hpp"

namespace {

using namespace restrip::verify;
using namespace restrip::verify::test;

bool accepted(const std::vector<std::string>& lines) {
  const AutomatonCertificate certificate = parse_automaton("altered.cert", text_of(lines));
  const ClassCheck check(certificate);
  return std::all_of(check.claims().begin(), check.claims().end(),
                     [](const AutomatonClaim& claim) { return claim.failures.count == 0; });
}

bool whole_fans_accepted(const std::vector<std::string>& lines) {
  return check_against_search(parse_automaton("good.cert", text_of(lines)), 4).failures.count == 0;
}

/// A certificate that must be refused, and what is wrong with it.
struct Crime {
  std::string name;
  std::vector<std::string> lines;
};

/// `count` crimes: rows of a kind, spread over the file, for which `change` gives another one.
void add_crimes(std::vector<Crime>& crimes, const std::string& name, const std::vector<std::string>& good,
                const std::string& kind, const RowChange& change, std::size_t count) {
  std::vector<std::size_t> rows;
  for (std::size_t i = 0; i < good.size(); ++i)
    if (good[i].rfind(kind + " ", 0) == 0 && change(words_of(good[i]))) rows.push_back(i);
  if (rows.size() < count) throw std::logic_error("too few rows to alter: " + name);
  for (std::size_t n = 0; n < count; ++n) {
    Crime crime{name, good};
    std::string& line = crime.lines[rows[(2 * n + 1) * rows.size() / (2 * count)]];
    crime.name += fmt::format(", {}", line);
    line = change(words_of(line)).value();
    crimes.push_back(std::move(crime));
  }
}

/// Another word at the end of a row.
RowChange ending_with(const std::string& word) {
  return [word](std::vector<std::string> words) -> std::optional<std::string> {
    if (words.back() == word) return {};
    words.back() = word;
    return joined(words);
  };
}

std::vector<Crime> crimes(const std::vector<std::string>& good) {
  const RowChange longer = [](std::vector<std::string> words) -> std::optional<std::string> {
    if (words[2].size() > 10) return {};
    words[2].insert(words[2].begin(), 'd');
    return joined(words);
  };
  // A and D keep a solid edge each: only better can be had.
  const RowChange without_chord = [](std::vector<std::string> words) -> std::optional<std::string> {
    const bool edge_at_a = words[3][0] != '-' || words[4][1] != '-';
    const bool edge_at_d = words[3][1] != '-' || words[4][0] != '-';
    if (words[5] != "chord" || !edge_at_a || !edge_at_d) return {};
    words[5] = "-";
    return joined(words);
  };
  // A and D get three solid edges.
  const RowChange with_chord = [](std::vector<std::string> words) -> std::optional<std::string> {
    if (words[3] != "tt" || words[4][0] == '-' || words[4][1] == '-' || words[5] == "chord") return {};
    words[5] = "chord";
    return joined(words);
  };
  const RowChange dashed_closing = [](std::vector<std::string> words) -> std::optional<std::string> {
    if (words[2] == "--") return {};
    words[2] = "--";
    return joined(words);
  };
  std::vector<Crime> list;
  add_crimes(list, "another witness", good, "class", longer, 1);
  add_crimes(list, "a letter costs more", good, "step", one_more(4), 1);
  add_crimes(list, "another origin", good, "from", ending_with("ee"), 1);
  add_crimes(list, "three edges", good, "meet", with_chord, 1);
  add_crimes(list, "a closing that could be better", good, "close", dashed_closing, 2);
  add_crimes(list, "a chord less", good, "meet", without_chord, 4);
  return list;
}

TEST(AutomatonCrimes, AreNoticed) {
  const std::vector<std::string> shipped = lines_of(RESTRIP_TABLES_DIR "/certificates/automaton.cert");
  EXPECT_TRUE(accepted(shipped));
  for (const Crime& crime : crimes(shipped)) EXPECT_FALSE(accepted(crime.lines)) << crime.name;
}

TEST(AutomatonCrimes, NoneIsSeenWhereSwapsHaveAPrice) {
  const std::vector<std::string> other = lines_of(RESTRIP_OTHER_TABLES_DIR "/certificates/automaton.cert");
  EXPECT_TRUE(whole_fans_accepted(other));
  EXPECT_TRUE(accepted(other));
}

}  // namespace
