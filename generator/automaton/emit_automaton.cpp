#include "automaton/emit_automaton.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>
#include <vector>

#include "tables/certificate_text.hpp"
#include "tables/number_lines.hpp"

namespace restrip::generator {
namespace {

using Rows = std::vector<std::string>;

std::string section_of(std::string_view name, const Rows& rows) {
  return fmt::format("section {}\nclaim rows {}\n{}\n", name, rows.size(), fmt::join(rows, "\n"));
}

/// The colours of the links of a class's witness in its case k, from left to right.
std::vector<bool> witness_links(const Automaton& automaton, const std::string& witness, Case k) {
  std::vector<const ArcStep*> steps;
  std::size_t at = 0;
  for (const char name : witness) {
    const auto letter =
        std::find_if(all_letters.begin(), all_letters.end(), [&](Letter l) { return text_of(l) == name; });
    steps.push_back(&automaton.classes[at].steps[static_cast<std::size_t>(letter - all_letters.begin())].value());
    at = steps.back()->to;
  }
  std::vector<bool> links{right_is_solid(k)};
  for (auto step = steps.rbegin(); step != steps.rend(); ++step) {
    k = (*step)->before[k];
    links.push_back(right_is_solid(k));
  }
  std::reverse(links.begin(), links.end());
  return links;
}

}  // namespace

RulesHeader automaton_header(const Automaton& automaton) {
  const auto [seconds, table] = automaton_arrays(automaton);
  const std::vector<TableArray>& arrays = table.arrays;
  std::vector<std::size_t> next;
  for (const ArcClass& c : automaton.classes)
    for (const auto& step : c.steps) next.push_back(step ? step->to : UINT8_MAX);
  std::vector<std::uint64_t> before;
  for (std::size_t i = 0; i < next.size(); ++i)
    before.push_back(arrays[1].values[2 * i] | std::uint64_t{arrays[1].values[2 * i + 1]} << 32U);
  std::string text = fmt::format(
      "// Rules of fans of any valence: {} classes of arcs, {} pairs of classes.\n"
      "// The cost: {} for a strip, 0 for a swap, {} for an isolated triangle.\n"
      "// Written by `restrip-generate tables`. Do not edit: change the generator, then build the target "
      "`regenerate`.\n"
      "// Format 2, explained in restrip/tables/automaton_format.hpp.\n#pragma once\n\n"
      "#include \"restrip/tables/automaton_format.hpp\"\n\nnamespace restrip::tables {{\n\n",
      automaton.classes.size(), automaton.meets.size() * seconds, strip_cost, isolated_cost);
  text +=
      fmt::format("inline constexpr ArcAutomaton<std::uint8_t, {}, {}, {}, {}, {}> automaton{{\n", all_letters.size(),
                  automaton.classes.size(), automaton.meets.size(), seconds, arrays.back().values.size());
  const auto block = [&](const std::string& lines) { text += "    {\n" + lines + "    },\n"; };
  block(numbers(next));
  block(numbers(before, " {:#x},"));
  for (std::size_t i = 2; i < arrays.size(); ++i) block(numbers(arrays[i].values));
  return {text + "};\n\n}  // namespace restrip::tables\n", table.bytes()};
}

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

std::string automaton_json(const Automaton& automaton) {
  nlohmann::ordered_json json;
  json["arcs"]["by value"] = automaton.counts.values;
  json["arcs"]["by value and ports"] = automaton.counts.with_ports;
  json["arcs"]["with the boundary, too"] = automaton.counts.with_boundary;
  json["classes"]["all"] = automaton.classes.size();
  json["classes"]["empty"] = 1;
  json["classes"]["without boundary"] = std::count_if(automaton.classes.begin(), automaton.classes.end(),
                                                      [](const ArcClass& c) { return c.can_be_first(); });
  // Shorter ones come first.
  json["longest witness"] = automaton.classes.back().witness.size();
  json["letters"] = all_letters.size();
  json["cases"] = all_cases.size();
  json["meetings"]["rows"] = automaton.meets.size();
  const auto [seconds, table] = automaton_arrays(automaton);
  json["meetings"]["columns"] = seconds;
  json["meetings"]["different"] = table.arrays.back().values.size();
  json["bytes"] = table.bytes();
  return json.dump(2) + "\n";
}

std::string classes_json(const Automaton& automaton) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const ArcClass& c : automaton.classes) {
    nlohmann::ordered_json json;
    json["witness"] = c.witness;
    for (Case k = 0; k < case_codes; ++k)
      if (c.costs[k])
        json["cases"].push_back({{"case", text_of(k)},
                                 {"value", std::to_string(*c.costs[k])},
                                 {"links", witness_links(automaton, c.witness, k)}});
    list.push_back(std::move(json));
  }
  return list.dump(1) + "\n";
}

}  // namespace restrip::generator
