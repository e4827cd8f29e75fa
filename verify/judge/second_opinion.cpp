#include "judge/second_opinion.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace restrip::verify {
namespace {

class SecondOpinion {
 public:
  explicit SecondOpinion(const RuleJudge& judge)
      : judge_(judge), operation_(judge.operation()), before_(operation_.before), after_(operation_.after) {}

  Agreement run() {
    for (Mask both = 0; both < judge_.before().size(); ++both) compare_configuration(judge_.before().coloring(both));
    for (const ColoringClass& configurations : judge_.before().classes()) compare_recolorings(configurations);
    return std::move(agreement_);
  }

 private:
  void compare_configuration(Colors configuration) {
    ++agreement_.configurations;
    const Mask edges = edge_set(operation_.before, configuration);
    const bool valid = judge_.before().valid(configuration);
    if (before_.valid(edges) != valid) disagree(configuration, "whether it is valid");
    if (valid && before_.joined(edges) != judge_.joined_by(configuration))
      disagree(configuration, "which ports it joins");
  }

  /// Those that are judged together with this configuration, by worlds, join the same ports, as was compared.
  void compare_recolorings(const ColoringClass& configurations) {
    const Colors configuration = configurations.first;
    const Mask edges = edge_set(operation_.before, configuration);
    const std::vector<Mask> forbidden = after_.forbidden(configuration.ports, before_.joined(edges));
    for (Mask kept = 0; kept <= configuration.ports; ++kept) {
      if (!is_subset(kept, configuration.ports) || !is_subset(configuration.ports & ~kept, operation_.may_give_up))
        continue;
      agreement_.pairs += configurations.colorings * mask_count(operation_.after.inner_edges());
      for (Mask inner = 0; inner < mask_count(operation_.after.inner_edges()); ++inner) {
        const Mask all = edge_set(operation_.after, {inner, kept});
        const bool legal =
            std::none_of(forbidden.begin(), forbidden.end(), [&](Mask set) { return is_subset(set, all); });
        if (legal != judge_.is_sound(configuration, {inner, kept}))
          disagree(configuration, "whether this recolouring is sound: " + drawn(operation_.after, {inner, kept}));
      }
    }
    agreement_.optima += configurations.colorings;
    ++agreement_.hitting_set_problems;
    const std::optional<Colors> best = judge_.best(configuration);
    const CostValues by_sets = least_cost(configuration, forbidden);
    const auto first_three = [](const CostValues& cost) { return std::array{cost[0], cost[1], cost[2]}; };
    if (!best || first_three(judge_.cost(configuration, *best)) != first_three(by_sets))
      disagree(configuration,
               fmt::format("the optimum, which costs {}, {}, {} by sets", by_sets[0], by_sets[1], by_sets[2]));
  }

  /// The first three criteria of the best that leaves an edge of each forbidden set dashed.
  CostValues least_cost(Colors configuration, const std::vector<Mask>& forbidden) const {
    const Side& side = operation_.after;
    const Mask everything = edge_set(side, {mask_count(side.inner_edges()) - 1, configuration.ports});
    const Mask removable =
        edge_set(side, {mask_count(side.inner_edges()) - 1, configuration.ports & operation_.may_give_up});
    std::optional<CostValues> least;
    for (const Mask removed : smallest_hitting_sets(forbidden, removable)) {
      const Mask kept = everything & ~removed;
      const std::int64_t given_up = solid_count(high_part(removed, side.inner_edges()));
      std::int64_t isolated = 0;
      for (const Mask triangle : after_.edges_of_triangles()) isolated += (triangle & kept) == 0 ? 1 : 0;
      const std::int64_t strips = std::int64_t{side.triangles} - solid_count(kept);
      const CostValues cost{strips, isolated + given_up, given_up};
      if (!least || cost < *least) least = cost;
    }
    return least.value_or(CostValues{-1, -1, -1});
  }

  void disagree(Colors configuration, const std::string& what) {
    agreement_.disagreements.add(fmt::format(
        "{}, inner {:x}, ports {:x}\n    before  {}\n  worlds and forbidden sets disagree on {}", operation_.name(),
        configuration.inner, configuration.ports, drawn(operation_.before, configuration), what));
  }

  const RuleJudge& judge_;
  const Operation& operation_;
  ForbiddenSets before_;
  ForbiddenSets after_;
  Agreement agreement_;
};

}  // namespace

Agreement second_opinion_on(const RuleJudge& judge) { return SecondOpinion(judge).run(); }

}  // namespace restrip::verify
