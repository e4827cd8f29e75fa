#include "list_check.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "draw.hpp"
#include "mutants.hpp"

namespace restrip::verify {
namespace {

/// A legal row.
struct Candidate {
  const Alternative* row = nullptr;
  Merit merit;
  PortPairs joined;
};

Merit preference_of(const SurveyedColoring& recoloring) {
  Merit merit = merit_of(recoloring.survey, recoloring.colors, recoloring.colors.ports);
  if (mutated(Mutant::lists_ignore_isolated)) merit.fewer_isolated = 0;
  return merit;
}

/// Point 4: stands in wherever `recoloring` would be sound, and is as good.
bool serves(const Candidate& candidate, const SurveyedColoring& recoloring) {
  return (candidate.merit >= preference_of(recoloring) || mutated(Mutant::lists_complete_by_pairs)) &&
         (candidate.joined.within(recoloring.survey.joined) || mutated(Mutant::lists_complete_by_merit));
}

}  // namespace

std::vector<SurveyedColoring> recolorings_of(const Patch& after, Mask ports) {
  std::vector<SurveyedColoring> all;
  for (Mask inner = 0; inner < mask_count(after.inner_edges()); ++inner)
    all.push_back({{inner, ports}, survey(after, {inner, ports})});
  return all;
}

void check_list(const Patch& after, const std::vector<SurveyedColoring>& recolorings, Mask ports, List list,
                const std::string& file, ListFailures& failures) {
  const auto fail = [&](ListClaim claim, const Alternative& row, const std::string& what) {
    failures[static_cast<std::size_t>(claim)].add(fmt::format("{}:{}: \"{}\"\n{}  {}", file, row.line, row.text(),
                                                              drawn(after, {row.inner, ports}, "    "), what));
  };
  if (list.empty() && !mutated(Mutant::lists_missing))
    failures[static_cast<std::size_t>(ListClaim::present)].add(
        fmt::format("{}: missing list: the ports {:x} have no row", file, ports));

  std::vector<Candidate> legal;
  for (const Alternative& row : list) {
    const SurveyedColoring& own = recolorings[row.inner];
    if (!own.survey.valid) {
      if (!mutated(Mutant::lists_illegal))
        fail(ListClaim::legal, row, "illegal alternative: " + fault_of(after, own.colors));
      continue;
    }
    const Candidate candidate{&row, preference_of(own), own.survey.joined};
    if (!legal.empty() && legal.back().merit < candidate.merit && !mutated(Mutant::lists_disorder))
      fail(ListClaim::ordered, row,
           fmt::format("out of order: it is preferred to the row before it, in line {}", legal.back().row->line));
    const auto cover = std::find_if(legal.begin(), legal.end(),
                                    [&](const Candidate& earlier) { return earlier.joined.within(candidate.joined); });
    if (cover != legal.end() && !mutated(Mutant::lists_covered))
      fail(
          ListClaim::uncovered, row,
          fmt::format("covered alternative: it joins {}; line {} is preferred and joins nothing else: {}",
                      listed(candidate.joined, after.ports()), cover->row->line, listed(cover->joined, after.ports())));
    legal.push_back(candidate);
  }

  Failures& incomplete = failures[static_cast<std::size_t>(ListClaim::complete)];
  for (const SurveyedColoring& recoloring : recolorings) {
    if (!recoloring.survey.valid || mutated(Mutant::lists_incomplete)) continue;
    if (std::any_of(legal.begin(), legal.end(), [&](const Candidate& row) { return serves(row, recoloring); }))
      continue;
    // Only the first is put into words.
    incomplete.add(
        incomplete.count != 0
            ? std::string{}
            : fmt::format("{}: the list of the ports {:x}\n  incomplete list: it has nothing as good for whoever "
                          "may join {} and nothing else as\n{}    inner {:x}",
                          file, ports, listed(recoloring.survey.joined, after.ports()),
                          drawn(after, recoloring.colors, "    "), recoloring.colors.inner));
  }
}

}  // namespace restrip::verify
