// Gives the verifier of the automata one deliberate fault, named by the argument, and tells the first certificate that
// shows it: a shipped one that is refused, or one altered in a way that breaks one claim and is accepted. With the
// fault `none` there must be no such certificate. Only the claims of one of the two automata are asked, by the fault's
// name.

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "altered_lines.hpp"
#include "automaton_certificate.hpp"
#include "automaton_mutants.hpp"
#include "class_check.hpp"
#include "named_mutant.hpp"
#include "turn_certificate.hpp"
#include "turn_check.hpp"
#include "turn_fans.hpp"

namespace {

using namespace restrip::verify;
using namespace restrip::verify::test;

std::vector<std::string> shipped(const std::string& family) {
  return lines_of(fmt::format("{}/certificates/{}.cert", RESTRIP_TABLES_DIR, family));
}

template <class Claims>
bool all_hold(const Claims& claims) {
  return std::all_of(claims.begin(), claims.end(), [](const auto& claim) { return claim.failures.count == 0; });
}

bool strips_accepted(const std::vector<std::string>& lines) {
  const AutomatonCertificate certificate = parse_automaton("altered.cert", text_of(lines));
  return all_hold(ClassCheck(certificate).claims());
}

bool indices_accepted(const std::vector<std::string>& lines) {
  const TurnCertificate certificate = parse_turn_automaton("altered.cert", text_of(lines));
  return all_hold(TurnCheck(certificate, 300).claims());
}

bool whole_index_fans_accepted() {
  const TurnCertificate certificate = parse_turn_automaton("shipped.cert", text_of(shipped("index-automaton")));
  return check_turns_against_search(certificate, 4).failures.count == 0;
}

/// A certificate that must be refused, and what is wrong with it.
struct Crime {
  std::string name;
  std::vector<std::string> lines;
};

/// `count` crimes: rows of a kind, spread over the file, for which `change` gives another one.
void add_crimes(std::vector<Crime>& crimes, const std::string& name, const std::vector<std::string>& good,
                const std::string& kind, const Change& change, std::size_t count) {
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
Change ending_with(const std::string& word) {
  return [word](std::vector<std::string> words) -> std::optional<std::string> {
    if (words.back() == word) return {};
    words.back() = word;
    return joined(words);
  };
}

std::vector<Crime> crimes_of_strips() {
  const std::vector<std::string> good = shipped("automaton");
  std::map<std::string, std::string> dashed;  // the value of the case with both links dashed, by class
  for (const std::string& line : good)
    if (const auto words = words_of(line); words[0] == "value" && words[2] == "--")
      dashed[words[1]] = words[3] + " " + words[4];
  const Change longer = [](std::vector<std::string> words) -> std::optional<std::string> {
    if (words[2].size() > 10) return {};
    words[2].insert(words[2].begin(), 'd');
    return joined(words);
  };
  // A and D keep a solid edge each: the value is true, only better can be had.
  const Change without_chord = [](std::vector<std::string> words) -> std::optional<std::string> {
    const bool edge_at_a = words[3][0] != '-' || words[4][1] != '-';
    const bool edge_at_d = words[3][1] != '-' || words[4][0] != '-';
    if (words[5] != "chord" || !edge_at_a || !edge_at_d) return {};
    words[5] = "-";
    words[6] = std::to_string(std::stoi(words[6]) - 1);
    return joined(words);
  };
  // A and D get three solid edges.
  const Change with_chord = [](std::vector<std::string> words) -> std::optional<std::string> {
    if (words[3] != "tt" || words[4][0] == '-' || words[4][1] == '-' || words[5] == "chord") return {};
    words[5] = "chord";
    words[6] = std::to_string(std::stoi(words[6]) + 1);
    return joined(words);
  };
  const Change dashed_closing = [&](std::vector<std::string> words) -> std::optional<std::string> {
    if (words[2] == "--") return {};
    return joined({words[0], words[1], "--", dashed.at(words[1])});
  };
  std::vector<Crime> crimes;
  add_crimes(crimes, "another witness", good, "class", longer, 1);
  add_crimes(crimes, "a letter adds more", good, "step", one_more(4), 1);
  add_crimes(crimes, "another origin", good, "from", ending_with("ee"), 1);
  add_crimes(crimes, "three edges", good, "meet", with_chord, 1);
  add_crimes(crimes, "a closing that could be better", good, "close", dashed_closing, 2);
  add_crimes(crimes, "a chord less", good, "meet", without_chord, 4);
  return crimes;
}

std::vector<Crime> crimes_of_indices() {
  const std::vector<std::string> good = shipped("index-automaton");
  std::vector<Crime> crimes;
  add_crimes(crimes, "a letter costs more", good, "step", one_more(4), 1);
  add_crimes(crimes, "another origin", good, "from", ending_with("ff"), 1);
  crimes.push_back({"no case over the left link", without_left_links(good)});
  return crimes;
}

}  // namespace

int main(int argc, char** argv) {
  const std::optional<AutomatonMutant> mutant = argc == 2 ? mutant_named<AutomatonMutant>(argv[1]) : std::nullopt;
  if (!mutant) {
    fmt::print(stderr, "usage: verify_automaton_mutants NAME, with a name from automaton_mutants.hpp\n");
    return 2;
  }
  const std::string_view name = argv[1];
  active_automaton_mutant = *mutant;
  std::string killer;
  const auto search = [&](const std::string& family, const auto& accepted, const std::vector<Crime>& crimes) {
    if (!accepted(shipped(family))) killer = "the shipped certificate";
    for (const Crime& crime : crimes)
      if (killer.empty() && accepted(crime.lines)) killer = crime.name;
  };
  if (!name.starts_with("turns_")) search("automaton", strips_accepted, crimes_of_strips());
  if (!name.starts_with("automaton_")) {
    if (!whole_index_fans_accepted()) killer = "the shipped certificate in whole fans";
    if (killer.empty()) search("index-automaton", indices_accepted, crimes_of_indices());
  }
  fmt::print("{}{}\n", killer.empty() ? "survived" : "killed by: ", killer);
  return killer.empty() ? 1 : 0;
}
