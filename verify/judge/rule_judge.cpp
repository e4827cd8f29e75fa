#include "judge/rule_judge.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace restrip::verify {
namespace {

/// Keeps of each class the colouring that costs least where no port is given up. Giving ports up adds the same to all
/// colourings of a class, so this is the best of its class everywhere.
auto keeping_the_best(const Operation& operation, std::vector<Colors>& best) {
  return [&operation, &best, least = std::vector<CostValues>()](Colors colors, std::uint32_t number) mutable {
    if (!searched(operation)) return;
    const CostValues cost = cost_of(operation, colors, 0);
    if (number < best.size() && least[number] <= cost) return;
    if (number >= best.size()) {
      best.resize(number + 1);
      least.resize(number + 1);
    }
    least[number] = cost;
    best[number] = colors;
  };
}

}  // namespace

RuleJudge::RuleJudge(const Operation& operation, FitTable& table)
    : operation_(operation),
      table_(table),
      before_(operation.before, most_solid(operation.constraint), table),
      after_(operation.after, most_solid(operation.constraint), table, keeping_the_best(operation, best_of_class_)),
      joinable_(mask_count(operation.ports())),
      best_(before_.classes().size()) {
  for (Mask ports = 0; ports < mask_count(operation.ports()); ++ports) {
    for_each_class_after(ports, [&](std::uint32_t number) {
      joinable_[ports].add(table_.classes()[after_.classes()[number].fit_class].joined);
    });
    if (searched(operation)) search(ports);
  }
}

void RuleJudge::compare_shortcut(const ColoringClass& configurations, const ColoringClass& recolorings, bool sound) {
  ++shortcuts_;
  const FitClass& after = table_.classes()[recolorings.fit_class];
  const PortPairs joined = key_of(configurations.first).joined;
  if (sound == after.joined.within(joined)) return;
  wrong_shortcuts_.add(fmt::format(
      "    before  {}\n    after   {}\n  the recolouring is {}sound by the worlds, {}sound by the joined pairs, {} "
      "before and {} after\n",
      drawn(operation_.before, configurations.first), drawn(operation_.after, recolorings.first), sound ? "" : "not ",
      sound ? "not " : "", listed(joined, operation_.ports()), listed(after.joined, operation_.ports())));
}

void RuleJudge::search(Mask ports) {
  for (const std::uint32_t configuration : before_.of_ports(ports)) {
    const ColoringClass& configurations = before_.classes()[configuration];
    std::optional<CostValues> least;
    for_each_class_after(ports, [&](std::uint32_t number) {
      const ColoringClass& recolorings = after_.classes()[number];
      pairs_ += configurations.colorings * recolorings.colorings;
      const bool sound = table_.sound(configurations.fit_class, recolorings.fit_class);
      compare_shortcut(configurations, recolorings, sound);
      if (!sound) return;
      const CostValues cost = this->cost(configurations.first, best_of_class_[number]);
      if (least && *least <= cost) return;
      least = cost;
      best_[configuration] = best_of_class_[number];
    });
  }
}

Judged RuleJudge::judged(Colors configuration, Colors recoloring) {
  const std::uint64_t question = std::uint64_t{before_.class_of(configuration)} * mask_count(most_colors) +
                                 concatenated(recoloring.inner, recoloring.ports, operation_.ports());
  const auto [place, is_new] = known_.try_emplace(question);
  Judged& judged = place->second;
  if (!is_new) return judged;
  if (!admissible(configuration.ports, recoloring.ports)) {
    judged.verdict = Verdict::wrong_ports;
  } else if (!is_sound(configuration, recoloring)) {
    judged.verdict = Verdict::unsound;
  } else if (searched(operation_)) {
    const CostValues own = cost(configuration, recoloring);
    const CostValues least = cost(configuration, best(configuration).value());
    const auto* const end = own.begin() + operation_.cost.size();
    const auto* const higher = std::mismatch(own.begin(), end, least.begin()).first;
    if (higher != end) judged = {Verdict::not_best, static_cast<unsigned>(higher - own.begin())};
  }
  return judged;
}

std::string RuleJudge::explained(Colors configuration, Colors recoloring, const Judged& judged) const {
  std::string text = fmt::format("    before  {}\n    after   {}\n", drawn(operation_.before, configuration),
                                 drawn(operation_.after, recoloring));
  const Mask taken = recoloring.ports & ~configuration.ports;
  const Mask refused = configuration.ports & ~recoloring.ports & ~operation_.may_give_up;
  switch (judged.verdict) {
    case Verdict::right:
      break;
    case Verdict::wrong_ports:
      for (unsigned port = 0; port < operation_.ports(); ++port) {
        if (is_solid(taken, port)) return text + fmt::format("  port {} was dashed and becomes solid\n", port);
        if (is_solid(refused, port)) return text + fmt::format("  port {} is given up and may not be\n", port);
      }
      break;
    case Verdict::unsound: {
      const std::string invalid = invalid_because(operation_.after, recoloring, most_solid(operation_.constraint));
      if (!invalid.empty()) {
        text += fmt::format("  unsound: {} after\n", invalid);
      } else {
        const std::size_t world = table_.refuting_world(class_before(configuration), class_after(recoloring));
        text += fmt::format("  unsound: with {}, there is no solid cycle before, but one after\n",
                            table_.worlds().text_of(table_.worlds().of(configuration.ports)[world]));
      }
      if (searched(operation_) && !best(configuration))
        text += "  no recolouring is sound here; the operation would have to give up more ports\n";
      break;
    }
    case Verdict::not_best: {
      const Colors better = best(configuration).value();
      const Criterion& criterion = operation_.cost[judged.criterion];
      text += fmt::format("    better  {}\n  not best: {} is {}, and may be {}\n", drawn(operation_.after, better),
                          text_of(criterion), cost(configuration, recoloring)[judged.criterion],
                          cost(configuration, better)[judged.criterion]);
      break;
    }
  }
  return text;
}

}  // namespace restrip::verify
