#include "automaton/emit_index_automaton.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>
#include <vector>

#include "number_lines.hpp"

namespace restrip::generator::indices {
namespace {

constexpr unsigned index_automaton_format_version = 1;

/// Where the cases of a longer arc come from, with the colours of the link before the letter, and what the letter
/// costs.
struct Move {
  std::uint64_t origins = 0;
  unsigned links = 0;
  int cost = 0;
  friend auto operator<=>(const Move&, const Move&) = default;
};

[[noreturn]] void too_large(const Weights& weights, const std::string& what) {
  throw std::invalid_argument(
      fmt::format("the automaton of the weights {},{},{} does not fit its header: {}; take "
                  "smaller weights in about the same proportion",
                  weights.restart, weights.swap, weights.isolated, what));
}

/// Everything the header holds.
struct HeaderNumbers {
  std::vector<std::size_t> next;
  std::vector<std::size_t> move;
  std::vector<std::uint64_t> origins;
  std::vector<unsigned> links;
  std::vector<int> move_cost;
  std::vector<std::size_t> first;
  std::vector<unsigned> cases;
  std::vector<int> costs;

  explicit HeaderNumbers(const Automaton& automaton) {
    std::map<Move, std::size_t> numbers;
    for (const ArcClass& c : automaton.classes) {
      first.push_back(cases.size());
      for (Case k = 0; k < case_codes; ++k)
        if (c.costs[k]) {
          cases.push_back(k);
          costs.push_back(*c.costs[k]);
        }
      for (const ArcStep& step : c.steps) {
        next.push_back(step.to);
        const Move made = move_of(c, step, automaton);
        const auto [place, is_new] = numbers.emplace(made, numbers.size());
        move.push_back(place->second);
        if (!is_new) continue;
        origins.push_back(made.origins);
        links.push_back(made.links);
        move_cost.push_back(made.cost);
      }
    }
    first.push_back(cases.size());
    if (cases.size() > UINT16_MAX) too_large(automaton.weights, fmt::format("{} cases of classes", cases.size()));
    if (const int most = *std::max_element(costs.begin(), costs.end()); most > UINT8_MAX)
      too_large(automaton.weights, fmt::format("a cost of {}", most));
  }

  [[nodiscard]] std::size_t bytes() const {
    return 3 * sizeof(std::uint16_t) +
           2 * (next.size() + move.size() + links.size() + move_cost.size() + first.size()) + 8 * origins.size() +
           cases.size() + costs.size();
  }

 private:
  /// The place of a case among those of its class.
  static std::size_t place_in(const ArcClass& c, Case wanted) {
    return static_cast<std::size_t>(
        std::count_if(c.costs.begin(), c.costs.begin() + wanted, [](const auto& cost) { return cost.has_value(); }));
  }

  static Move move_of(const ArcClass& from, const ArcStep& step, const Automaton& automaton) {
    Move made{0, 0, step.cost};
    unsigned shift = 0;
    for (Case k = 0; k < case_codes; ++k) {
      if (!automaton.classes[step.to].costs[k]) continue;
      const std::size_t place = place_in(from, step.before[k]);
      if (place > 15 || shift > 60) too_large(automaton.weights, "more than 16 cases of a class");
      made.origins |= std::uint64_t{place} << shift;
      if (right_of(step.before[k]) != Reach::dashed) made.links |= 1U << shift / 4;
      shift += 4;
    }
    return made;
  }
};

bool right_is_solid(Case k) { return right_of(k) != Reach::dashed; }

}  // namespace

RulesHeader automaton_header(const Automaton& automaton) {
  const HeaderNumbers all(automaton);
  const Weights& weights = automaton.weights;
  std::string text = fmt::format(
      "// Rules of fans of any valence under the cost {} * strips + {} * swaps + {} * isolated triangles: {} classes "
      "of "
      "arcs.\n"
      "// Written by `restrip-generate automaton --cost {},{},{}`. Do not edit: change the generator, then build the "
      "target\n// `regenerate`.\n"
      "// Format {}, explained in restrip/tables/index_automaton_format.hpp.\n#pragma once\n\n"
      "#include \"restrip/tables/index_automaton_format.hpp\"\n\nnamespace restrip::tables {{\n\n",
      weights.restart, weights.swap, weights.isolated, automaton.classes.size(), weights.restart, weights.swap,
      weights.isolated, index_automaton_format_version);
  text += fmt::format("inline constexpr IndexAutomaton<{}, {}, {}> index_automaton{{\n    {}, {}, {},\n",
                      automaton.classes.size(), all.cases.size(), all.origins.size(), weights.restart, weights.swap,
                      weights.isolated);
  const auto block = [&](const std::string& lines) { text += "    {\n" + lines + "    },\n"; };
  block(numbers(all.next));
  block(numbers(all.move));
  block(numbers(all.origins, " {:#x},"));
  block(numbers(all.links));
  block(numbers(all.move_cost));
  block(numbers(all.first));
  block(numbers(all.cases));
  block(numbers(all.costs));
  return {text + "};\n\n}  // namespace restrip::tables\n", all.bytes()};
}

AutomatonCertificate automaton_certificate(const Automaton& automaton) {
  const Weights& weights = automaton.weights;
  Rows cost;
  cost.add("weights {} {} {}", weights.restart, weights.swap, weights.isolated);
  Rows classes;
  for (std::size_t x = 0; x < automaton.classes.size(); ++x) {
    const ArcClass& c = automaton.classes[x];
    classes.add("class {} {}", x, witness_text(c.witness));
    for (Case k = 0; k < case_codes; ++k)
      if (c.costs[k]) classes.add("value {} {} {}", x, text_of(k), *c.costs[k]);
    for (const Letter letter : all_letters) {
      const ArcStep& step = c.steps[static_cast<std::size_t>(letter)];
      classes.add("step {} {} {} {}", x, text_of(letter), step.to, step.cost);
      for (Case k = 0; k < case_codes; ++k)
        if (automaton.classes[step.to].costs[k])
          classes.add("from {} {} {} {}", x, text_of(letter), text_of(k), text_of(step.before[k]));
    }
  }
  const std::size_t rows = cost.count() + classes.count();
  return {certificate("index-automaton", {cost.section("cost"), classes.section("classes")}, rows), rows};
}

std::string automaton_json(const Automaton& automaton) {
  const HeaderNumbers all(automaton);
  nlohmann::ordered_json json;
  json["cost"]["restart"] = automaton.weights.restart;
  json["cost"]["swap"] = automaton.weights.swap;
  json["cost"]["isolated"] = automaton.weights.isolated;
  if (automaton.undropped)
    json["classes"]["with every case"] = *automaton.undropped;
  else
    json["classes"]["with every case"] = fmt::format("more than {}", most_classes);
  json["classes"]["all"] = automaton.classes.size();
  json["classes"]["empty"] = 1;
  json["longest witness"] = automaton.classes.back().witness.size();
  json["letters"] = all_letters.size();
  json["cases"]["all"] = case_codes;
  std::size_t most = 0;
  for (std::size_t c = 0; c < automaton.classes.size(); ++c) most = std::max(most, all.first[c + 1] - all.first[c]);
  json["cases"]["of a class at most"] = most;
  json["cases"]["of all classes"] = all.cases.size();
  json["bytes"] = all.bytes();
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
                                 {"links", witness_links(automaton, all_letters, c.witness, k, right_is_solid)}});
    list.push_back(std::move(json));
  }
  return list.dump(1) + "\n";
}

}  // namespace restrip::generator::indices
