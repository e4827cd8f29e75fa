#include "rule_judge.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "draw.hpp"

namespace restrip::verify::operations {
namespace {

/// Of each class the colouring that costs least where no port is given up. Giving ports up adds the same to all
/// colourings of a class, so this is the best of its class everywhere.
std::vector<Colors> best_of_classes(const OperationFile& operation, const FitClasses& classes) {
  std::vector<Colors> best(classes.classes.size());
  std::vector<std::optional<CostValues>> least(classes.classes.size());
  for (Mask both = 0; both < classes.class_of_coloring.size(); ++both) {
    const std::uint32_t number = classes.class_of_coloring[both];
    if (number == FitClasses::not_valid) continue;
    const Colors colors{high_part(both, classes.ports), low_part(both, classes.ports)};
    const CostValues cost = cost_of(operation, colors, 0);
    if (least[number] && *least[number] <= cost) continue;
    least[number] = cost;
    best[number] = colors;
  }
  return best;
}

}  // namespace

RuleJudge::RuleJudge(const OperationFile& operation)
    : operation_(operation),
      worlds_(operation.constraint, operation.ports()),
      before_(operation.before, operation.most_solid(), worlds_),
      after_(operation.after, operation.most_solid(), worlds_),
      best_of_class_(best_of_classes(operation, after_)),
      best_(before_.classes.size()) {
  for (Mask ports = 0; ports < mask_count(operation.ports()); ++ports) search(ports);
}

void RuleJudge::search(Mask ports) {
  std::vector<std::optional<CostValues>> least(before_.classes.size());
  NumberSet fitted(worlds_.of(ports).size());
  for (Mask kept = 0; kept <= ports; ++kept) {
    if (!admissible(ports, kept)) continue;
    if (mutated(OperationMutant::best_keeps_ports) && kept != ports) continue;
    const std::vector<std::uint32_t> world_of = worlds_.restrictions(ports, kept);
    for (const std::uint32_t number : after_.of_ports[kept]) {
      if (mutated(OperationMutant::forget_last_class) && number == after_.of_ports[kept].back()) continue;
      const FitClass& recolorings = after_.classes[number];
      fitted.clear();
      for (std::size_t world = 0; world < world_of.size(); ++world)
        if (recolorings.worlds.has(world_of[world])) fitted.add(world);
      for (const std::uint32_t configuration : before_.of_ports[ports]) {
        const FitClass& configurations = before_.classes[configuration];
        pairs_ += configurations.colorings * recolorings.colorings;
        ++shortcuts_;
        const bool sound = configurations.worlds.within(fitted);
        if (sound != recolorings.joined.within(configurations.joined) && wrong_shortcuts_++ == 0)
          wrong_shortcut_ = fmt::format(
              "    before  {}\n    after   {}\n  the recolouring is {}sound by the worlds, {}sound by the joined "
              "pairs, {} "
              "before and {} after\n",
              drawn(operation_.before, configurations.first), drawn(operation_.after, recolorings.first),
              sound ? "" : "not ", sound ? "not " : "", listed(configurations.joined, operation_.ports()),
              listed(recolorings.joined, operation_.ports()));
        if (!sound) continue;
        const Colors candidate = best_of_class_[number];
        const CostValues cost = this->cost(configurations.first, candidate);
        if (least[configuration] && *least[configuration] <= cost) continue;
        least[configuration] = cost;
        best_[configuration] = candidate;
      }
    }
  }
}

std::optional<std::size_t> RuleJudge::refuting_world(Colors configuration, Colors recoloring) const {
  const NumberSet& before = before_.classes[before_.class_of(configuration)].worlds;
  const NumberSet& after = after_.classes[after_.class_of(recoloring)].worlds;
  const std::vector<std::uint32_t> world_of = worlds_.restrictions(configuration.ports, recoloring.ports);
  const std::size_t worlds = world_of.size() - (mutated(OperationMutant::worlds_stop_early) ? 1 : 0);
  for (std::size_t world = 0; world < worlds; ++world)
    if (before.has(world) && !after.has(world_of[world])) return world;
  return {};
}

Judged RuleJudge::judged(Colors configuration, Colors recoloring) {
  const std::uint64_t question = std::uint64_t{before_.class_of(configuration)} * mask_count(most_colors) +
                                 concatenated(recoloring.inner, recoloring.ports, operation_.ports());
  const auto [place, is_new] = known_.try_emplace(question);
  Judged& judged = place->second;
  if (!is_new) return judged;
  if (!admissible(configuration.ports, recoloring.ports)) {
    judged.verdict = Verdict::wrong_ports;
  } else if (after_.class_of(recoloring) == FitClasses::not_valid || refuting_world(configuration, recoloring)) {
    judged.verdict = Verdict::unsound;
  } else {
    const CostValues own = cost(configuration, recoloring);
    const CostValues least = cost(configuration, best(configuration).value());
    const std::size_t compared = operation_.cost.size() - (mutated(OperationMutant::skip_last_cost) ? 1 : 0);
    const auto* const end = own.begin() + compared;
    const auto* const higher = std::mismatch(own.begin(), end, least.begin()).first;
    if (higher != end && !mutated(OperationMutant::accept_worse))
      judged = {Verdict::not_best, static_cast<unsigned>(higher - own.begin())};
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
      const std::string invalid = invalid_because(operation_.after, recoloring, operation_.most_solid());
      if (!invalid.empty()) {
        text += fmt::format("  unsound: {} after\n", invalid);
      } else if (const std::optional<std::size_t> world = refuting_world(configuration, recoloring)) {
        text += fmt::format("  unsound: with {}, there is no solid cycle before, but one after\n",
                            worlds_.text_of(worlds_.of(configuration.ports)[*world]));
      }
      if (!best(configuration))
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

}  // namespace restrip::verify::operations
