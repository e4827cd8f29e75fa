#include "second_opinion.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "draw.hpp"

namespace restrip::verify {

SecondOpinion::SecondOpinion(const Operation& operation)
    : operation_(operation), before_(operation.before), after_(operation.after) {}

SecondOpinion::Verdict SecondOpinion::verdict(const PortSlice& slice, PortPairs joined_before) const {
  const Patch& patch = operation_.after;
  const std::vector<Mask> forbidden = after_.forbidden(slice.ports, joined_before);
  Verdict result;
  for (const SurveyedColoring& recoloring : slice.after) {
    const Mask edges = edge_set(patch, recoloring.colors);
    result.legal.push_back(
        std::none_of(forbidden.begin(), forbidden.end(), [&](Mask set) { return is_subset(set, edges); }));
  }

  // Solid ports of a fan stay solid, so only inner edges can be left out; a flip may leave ports out as well.
  const Mask everything = edge_set(patch, {mask_count(patch.inner_edges()) - 1, slice.ports});
  const Mask removable = operation_.gives_ports_up ? everything : low_part(everything, patch.inner_edges());
  result.best = {-1, 0, 0};
  for (const Mask removed : smallest_hitting_sets(forbidden, removable)) {
    const Mask kept = everything & ~removed;
    int isolated = 0;
    for (const Mask triangle : after_.edges_of_triangles()) isolated += (triangle & kept) == 0 ? 1 : 0;
    const int ports_kept = static_cast<int>(solid_count(high_part(kept, patch.inner_edges())));
    const int given_up = static_cast<int>(solid_count(slice.ports)) - ports_kept;
    result.best = std::max(result.best, {static_cast<int>(solid_count(kept)), -(isolated + given_up), ports_kept});
  }
  return result;
}

void SecondOpinion::compare(const PortSlice& slice) {
  std::map<PortPairs, Verdict> verdicts;
  for (const SurveyedColoring& configuration : slice.before) {
    ++agreement_.configurations;
    const Mask edges = edge_set(operation_.before, configuration.colors);
    if (before_.valid(edges) != configuration.survey.valid) disagree(configuration, "whether it is valid");
    if (!configuration.survey.valid) continue;
    const PortPairs joined = before_.joined(edges);
    if (joined != configuration.survey.joined) disagree(configuration, "which ports it joins");
    auto [place, is_new] = verdicts.try_emplace(joined);
    if (is_new) place->second = verdict(slice, joined);
    compare_pairs(slice, configuration, place->second);
  }
  agreement_.hitting_set_problems += verdicts.size();
}

void SecondOpinion::compare_pairs(const PortSlice& slice, const SurveyedColoring& configuration,
                                  const Verdict& second) {
  Merit best{-1, 0, 0};
  for (std::size_t i = 0; i < slice.after.size(); ++i) {
    const SurveyedColoring& recoloring = slice.after[i];
    const bool legal = recoloring.survey.valid && recoloring.survey.joined.within(configuration.survey.joined);
    if (legal != second.legal[i])
      disagree(configuration, fmt::format("whether this recolouring is sound:\n{}",
                                          drawn(operation_.after, recoloring.colors, "    ")));
    if (legal) best = std::max(best, merit_of(recoloring.survey, recoloring.colors, slice.ports));
  }
  agreement_.pairs += slice.after.size();
  ++agreement_.optima;
  if (best != second.best)
    disagree(configuration,
             fmt::format("the optimum: {} solid edges and {} isolated by strips, {} and {} by sets", best.solid,
                         -best.fewer_isolated, second.best.solid, -second.best.fewer_isolated));
}

void SecondOpinion::disagree(const SurveyedColoring& configuration, const std::string& what) {
  Failures& failures = agreement_.disagreements;
  failures.add(failures.count != 0
                   ? std::string{}
                   : fmt::format("{}, inner {:x}, ports {:x}\n  before:\n{}  strips and forbidden sets disagree on {}",
                                 operation_.name(), configuration.colors.inner, configuration.colors.ports,
                                 drawn(operation_.before, configuration.colors, "    "), what));
}

}  // namespace restrip::verify
