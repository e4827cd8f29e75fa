#include "automaton/automaton_layout.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstdint>
#include <map>
#include <string_view>
#include <vector>

namespace restrip::generator {
namespace {

using Rows = std::vector<std::string>;

std::string section_of(std::string_view name, const Rows& rows) {
  return fmt::format("section {}\nclaim rows {}\n{}\n", name, rows.size(), fmt::join(rows, "\n"));
}

}  // namespace

AutomatonArrays automaton_arrays(const Automaton& automaton) {
  std::map<unsigned, std::size_t> number;
  std::vector<std::size_t> meet;
  std::vector<unsigned> meetings;
  for (const std::vector<Meeting>& row : automaton.meets)
    for (const Meeting& m : row) {
      const unsigned word = m.first | m.second << 4U | (m.chord ? 1U : 0U) << 8U;
      const auto [place, is_new] = number.emplace(word, number.size());
      if (is_new) meetings.push_back(word);
      meet.push_back(place->second);
    }
  std::vector<std::size_t> next;
  TableArray before{"before", 32, {}};
  std::vector<unsigned> closed;
  std::vector<std::size_t> first;
  std::vector<std::size_t> second;
  for (const ArcClass& c : automaton.classes) {
    for (const auto& step : c.steps) {
      next.push_back(step ? step->to : 0);
      std::uint64_t cases = 0;
      for (Case to = 0; step && to < case_codes; ++to)
        if (automaton.classes[step->to].costs[to]) cases |= std::uint64_t{step->before[to]} << 4U * to;
      before.values.push_back(static_cast<std::uint32_t>(cases));
      before.values.push_back(static_cast<std::uint32_t>(cases >> 32U));
    }
    closed.push_back(c.closing.value_or(both_dashed));
    first.push_back(c.as_first);
    second.push_back(c.as_second);
  }
  return {automaton.meets.at(0).size(),
          {0,
           {array_of("next", next), before, array_of("closed", closed), array_of("first", first),
            array_of("second", second), array_of("meet", meet), array_of("meetings", meetings)}}};
}

AutomatonCertificate automaton_certificate(const Automaton& automaton) {
  const Rows cost{fmt::format("weights {} 0 {}", strip_cost, isolated_cost)};
  Rows classes;
  for (std::size_t x = 0; x < automaton.classes.size(); ++x) {
    const ArcClass& c = automaton.classes[x];
    classes.push_back(fmt::format("class {} {} {} {}", x, c.witness.empty() ? "-" : c.witness,
                                  c.can_be_first() ? std::to_string(c.as_first) : "-",
                                  x == 0 ? "-" : std::to_string(c.as_second)));
    for (Case k = 0; k < case_codes; ++k)
      if (c.costs[k]) classes.push_back(fmt::format("value {} {} {}", x, text_of(k), *c.costs[k]));
    for (std::size_t place = 0; place < c.steps.size(); ++place) {
      const auto& step = c.steps[place];
      if (!step) continue;
      const char letter = text_of(all_letters.at(place));
      classes.push_back(fmt::format("step {} {} {} {}", x, letter, step->to, step->cost));
      for (Case k = 0; k < case_codes; ++k)
        if (automaton.classes[step->to].costs[k])
          classes.push_back(fmt::format("from {} {} {} {}", x, letter, text_of(k), text_of(step->before[k])));
    }
  }
  Rows closings;
  for (std::size_t x = 1; x < automaton.classes.size(); ++x)
    if (const auto& closing = automaton.classes[x].closing)
      closings.push_back(fmt::format("close {} {}", x, text_of(*closing)));
  Rows meetings;
  for (std::size_t x = 0; x < automaton.meets.size(); ++x)
    for (std::size_t y = 0; y < automaton.meets[x].size(); ++y) {
      const Meeting& m = automaton.meets[x][y];
      meetings.push_back(
          fmt::format("meet {} {} {} {} {}", x, y, text_of(m.first), text_of(m.second), m.chord ? "chord" : "-"));
    }
  const std::size_t rows = cost.size() + classes.size() + closings.size() + meetings.size();
  const std::string text = "restrip-certificate 2\nfamily automaton\n" + section_of("cost", cost) +
                           section_of("classes", classes) + section_of("closings", closings) +
                           section_of("meetings", meetings);
  return {sealed(text, rows), rows};
}

}  // namespace restrip::generator
