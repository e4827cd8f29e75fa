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

constexpr unsigned automaton_format_version = 2;

/// In the header, for a letter that is not allowed.
constexpr std::size_t no_class = UINT8_MAX;

/// The contents of the header.
struct HeaderNumbers {
  std::vector<std::size_t> next;
  std::vector<std::uint64_t> before;
  std::vector<unsigned> closed;
  std::vector<std::size_t> first;
  std::vector<std::size_t> second;
  std::vector<std::size_t> meet;
  std::vector<unsigned> meetings;

  explicit HeaderNumbers(const Automaton& automaton) {
    std::map<unsigned, std::size_t> numbers;
    for (const std::vector<Meeting>& row : automaton.meets)
      for (const Meeting& m : row) {
        const unsigned word = m.first | m.second << 4U | (m.chord ? 1U : 0U) << 8U;
        const auto [place, is_new] = numbers.emplace(word, numbers.size());
        if (is_new) meetings.push_back(word);
        meet.push_back(place->second);
      }
    for (const ArcClass& c : automaton.classes) {
      for (const auto& step : c.steps) {
        next.push_back(step ? step->to : no_class);
        std::uint64_t& origins = before.emplace_back(0U);
        for (Case from = 0; step && from < case_codes; ++from)
          if (automaton.classes[step->to].costs[from]) origins |= std::uint64_t{step->before[from]} << 4U * from;
      }
      closed.push_back(c.closing.value_or(both_dashed));
      first.push_back(c.as_first);
      second.push_back(c.as_second);
    }
  }
};

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
  const HeaderNumbers all(automaton);
  std::string text = fmt::format(
      "// Rules of fans of any valence: {} classes of arcs, {} pairs of classes.\n"
      "// The cost: {} for a strip, 0 for a swap, {} for an isolated triangle.\n"
      "// Written by `restrip-generate tables`. Do not edit: change the generator, then build the target "
      "`regenerate`.\n"
      "// Format {}, explained in restrip/tables/automaton_format.hpp.\n#pragma once\n\n"
      "#include \"restrip/tables/automaton_format.hpp\"\n\nnamespace restrip::tables {{\n\n",
      automaton.classes.size(), all.meet.size(), strip_cost, isolated_cost, automaton_format_version);
  text +=
      fmt::format("inline constexpr ArcAutomaton<std::uint8_t, {}, {}, {}, {}, {}> automaton{{\n", all_letters.size(),
                  automaton.classes.size(), automaton.meets.size(), automaton.meets[0].size(), all.meetings.size());
  const auto block = [&](const std::string& lines) { text += "    {\n" + lines + "    },\n"; };
  block(numbers(all.next));
  block(numbers(all.before, " {:#x},"));
  block(numbers(all.closed));
  block(numbers(all.first));
  block(numbers(all.second));
  block(numbers(all.meet));
  block(numbers(all.meetings));
  return {text + "};\n\n}  // namespace restrip::tables\n", automaton_arrays(automaton).table.bytes()};
}

AutomatonArrays automaton_arrays(const Automaton& automaton) {
  HeaderNumbers all(automaton);
  std::replace(all.next.begin(), all.next.end(), no_class, std::size_t{0});
  TableArray before{"before", 32, {}};
  for (const std::uint64_t cases : all.before) {
    before.values.push_back(static_cast<std::uint32_t>(cases));
    before.values.push_back(static_cast<std::uint32_t>(cases >> 32U));
  }
  return {automaton.meets.at(0).size(),
          {0,
           {array_of("next", all.next), before, array_of("closed", all.closed), array_of("first", all.first),
            array_of("second", all.second), array_of("meet", all.meet), array_of("meetings", all.meetings)}}};
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
  json["meetings"]["columns"] = automaton.meets[0].size();
  json["meetings"]["different"] = HeaderNumbers(automaton).meetings.size();
  json["bytes"] = automaton_arrays(automaton).table.bytes();
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
