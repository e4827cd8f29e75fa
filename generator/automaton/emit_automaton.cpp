#include "automaton/emit_automaton.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <vector>

#include "number_lines.hpp"

namespace restrip::generator {
namespace {

constexpr unsigned automaton_format_version = 1;
constexpr unsigned no_class = 255;
constexpr std::size_t letters = all_letters.size();

/// Everything the header holds.
struct Numbers {
  std::vector<std::size_t> next;
  std::vector<std::uint64_t> before;
  std::vector<unsigned> closed;
  std::vector<std::size_t> first;
  std::vector<std::size_t> second;
  std::vector<std::size_t> meet;
  std::vector<unsigned> meetings;

  explicit Numbers(const Automaton& automaton) {
    if (automaton.classes.size() > no_class || automaton.meetings.size() > 256)
      throw std::logic_error("the automaton does not fit in bytes");
    for (const ArcClass& c : automaton.classes) {
      for (const auto& step : c.steps) {
        next.push_back(step ? step->to : no_class);
        std::uint64_t cases = 0;
        if (step)
          for (const Case after : all_cases) cases |= std::uint64_t{step->before[after]} << 4U * after;
        before.push_back(cases);
      }
      closed.push_back(c.closing.arc);
      first.push_back(c.as_first);
      second.push_back(c.as_second);
    }
    for (const auto& row : automaton.meets) meet.insert(meet.end(), row.begin(), row.end());
    for (const Meeting& m : automaton.meetings)
      meetings.push_back(m.first | m.second << 4U | (m.chord ? 1U : 0U) << 8U);
  }

  [[nodiscard]] std::size_t bytes() const {
    return next.size() + 8 * before.size() + closed.size() + first.size() + second.size() + meet.size() +
           2 * meetings.size();
  }
};

std::string in_words(Value value) { return fmt::format("{} {}", value.solid, -value.fewer_isolated); }

std::size_t arcs_without_boundary(const Automaton& automaton) {
  return static_cast<std::size_t>(std::count_if(automaton.classes.begin() + 1, automaton.classes.end(),
                                                [](const ArcClass& c) { return !c.boundary; }));
}

std::size_t longest_witness(const Automaton& automaton) {
  std::size_t longest = 0;
  for (const ArcClass& c : automaton.classes) longest = std::max(longest, c.witness.size());
  return longest;
}

Rows class_rows(const Automaton& automaton) {
  Rows rows;
  for (std::size_t x = 0; x < automaton.classes.size(); ++x) {
    const ArcClass& c = automaton.classes[x];
    rows.add("class {} {}", x, witness_text(c.witness));
    for (const Case k : all_cases)
      if (c.values[k]) rows.add("value {} {} {}", x, text_of(k), in_words(*c.values[k]));
    for (const Letter letter : all_letters) {
      const auto& step = c.steps[static_cast<std::size_t>(letter)];
      if (!step) continue;
      rows.add("step {} {} {} {}", x, text_of(letter), step->to, in_words(step->gain));
      for (const Case k : all_cases)
        if (automaton.classes[step->to].values[k])
          rows.add("from {} {} {} {}", x, text_of(letter), text_of(k), text_of(step->before[k]));
    }
  }
  return rows;
}

Rows closing_rows(const Automaton& automaton) {
  Rows rows;
  for (std::size_t x = 1; x < automaton.classes.size(); ++x) {
    const ArcClass& c = automaton.classes[x];
    if (!c.boundary) rows.add("close {} {} {}", x, text_of(c.closing.arc), in_words(c.closing.value));
  }
  return rows;
}

Rows meeting_rows(const Automaton& automaton) {
  Rows rows;
  for (std::size_t x = 1; x < automaton.classes.size(); ++x) {
    if (automaton.classes[x].boundary) continue;
    for (std::size_t y = 1; y < automaton.classes.size(); ++y) {
      const auto [meeting, value] = automaton.meeting(x, y);
      rows.add("meet {} {} {} {} {} {}", x, y, text_of(meeting.first), text_of(meeting.second),
               meeting.chord ? "chord" : "-", in_words(value));
    }
  }
  return rows;
}

bool right_is_solid(Case k) { return right_of(k) != Reach::dashed; }

}  // namespace

RulesHeader automaton_header(const Automaton& automaton) {
  const Numbers all(automaton);
  std::string text = fmt::format(
      "// Rules of fans of any valence: {} classes of arcs, {} pairs of classes.\n"
      "// Written by `restrip-generate tables`. Do not edit: change the generator, then build the target "
      "`regenerate`.\n"
      "// Format {}, explained in restrip/tables/automaton_format.hpp.\n#pragma once\n\n"
      "#include \"restrip/tables/automaton_format.hpp\"\n\nnamespace restrip::tables {{\n\n",
      automaton.classes.size(), all.meet.size(), automaton_format_version);
  text += fmt::format("inline constexpr ArcAutomaton<{}, {}, {}, {}> automaton{{\n", automaton.classes.size(),
                      automaton.meets.size(), automaton.meets.at(0).size(), automaton.meetings.size());
  const auto block = [&](const std::string& lines) { text += "    {\n" + lines + "    },\n"; };
  block(numbers(all.next));
  block(numbers(all.before, " {:#x},"));
  block(numbers(all.closed));
  block(numbers(all.first));
  block(numbers(all.second));
  block(numbers(all.meet));
  block(numbers(all.meetings));
  return {text + "};\n\n}  // namespace restrip::tables\n", all.bytes()};
}

AutomatonCertificate automaton_certificate(const Automaton& automaton) {
  const Rows classes = class_rows(automaton);
  const Rows closings = closing_rows(automaton);
  const Rows meetings = meeting_rows(automaton);
  const std::size_t rows = classes.count() + closings.count() + meetings.count();
  return {certificate("automaton",
                      {classes.section("classes"), closings.section("closings"), meetings.section("meetings")}, rows),
          rows};
}

std::string automaton_json(const Automaton& automaton) {
  nlohmann::ordered_json json;
  json["arcs"]["by value"] = automaton.counts.values;
  json["arcs"]["by value and ports"] = automaton.counts.with_ports;
  json["arcs"]["with the boundary, too"] = automaton.counts.with_boundary;
  json["classes"]["all"] = automaton.classes.size();
  json["classes"]["empty"] = 1;
  json["classes"]["without boundary"] = arcs_without_boundary(automaton);
  json["longest witness"] = longest_witness(automaton);
  json["letters"] = letters;
  json["cases"] = all_cases.size();
  json["meetings"]["rows"] = automaton.meets.size();
  json["meetings"]["columns"] = automaton.meets.at(0).size();
  json["meetings"]["different"] = automaton.meetings.size();
  json["bytes"] = Numbers(automaton).bytes();
  return json.dump(2) + "\n";
}

std::string classes_json(const Automaton& automaton) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const ArcClass& c : automaton.classes) {
    nlohmann::ordered_json json;
    json["witness"] = c.witness;
    for (const Case k : all_cases)
      if (c.values[k])
        json["cases"].push_back({{"case", text_of(k)},
                                 {"value", in_words(*c.values[k])},
                                 {"links", witness_links(automaton, all_letters, c.witness, k, right_is_solid)}});
    list.push_back(std::move(json));
  }
  return list.dump(1) + "\n";
}

}  // namespace restrip::generator
