#include "linked/list_check.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace restrip::verify {

std::vector<Recoloring> recolorings_of(const Side& after, Mask ports) {
  std::vector<Recoloring> all;
  for (Mask inner = 0; inner < mask_count(after.inner_edges()); ++inner) {
    const Colors colors{inner, ports};
    const Survey found = survey(after, colors);
    all.push_back({colors, found, {static_cast<int>(solid_count(inner)), -static_cast<int>(found.isolated)}});
  }
  return all;
}

void check_list(const Side& after, const std::vector<Recoloring>& recolorings, Mask ports, List list,
                const std::string& file, ListFailures& failures) {
  const auto fail = [&](ListClaim claim, const Alternative& row, const std::string& what) {
    failures[static_cast<std::size_t>(claim)].add(
        fmt::format("{}:{}: \"{}\"\n    {}\n  {}", file, row.line, row.text(), drawn(after, {row.inner, ports}), what));
  };
  if (list.empty())
    failures[static_cast<std::size_t>(ListClaim::present)].add(
        fmt::format("{}: missing list: the ports {:x} have no row", file, ports));
  struct Legal {
    const Alternative* row;
    const Recoloring* own;
  };
  std::vector<Legal> legal;
  for (const Alternative& row : list) {
    const Recoloring& own = recolorings[row.inner];
    if (!own.survey.valid) {
      fail(ListClaim::legal, row,
           "illegal alternative: " + invalid_because(after, own.colors, most_solid(Constraint::strips)));
      continue;
    }
    if (!legal.empty() && legal.back().own->merit < own.merit)
      fail(ListClaim::ordered, row,
           fmt::format("out of order: it is preferred to the row before it, in line {}", legal.back().row->line));
    const auto cover = std::find_if(legal.begin(), legal.end(), [&](const Legal& earlier) {
      return earlier.own->survey.joined.within(own.survey.joined);
    });
    if (cover != legal.end())
      fail(ListClaim::uncovered, row,
           fmt::format("covered alternative: it joins {}; line {} is preferred and joins no other ports: {}",
                       listed(own.survey.joined, after.ports()), cover->row->line,
                       listed(cover->own->survey.joined, after.ports())));
    legal.push_back({&row, &own});
  }
  Failures& incomplete = failures[static_cast<std::size_t>(ListClaim::complete)];
  for (const Recoloring& recoloring : recolorings) {
    if (!recoloring.survey.valid) continue;
    // Sound wherever the recolouring is sound, and as good.
    const auto serves = [&](const Legal& row) {
      return row.own->merit >= recoloring.merit && row.own->survey.joined.within(recoloring.survey.joined);
    };
    if (std::any_of(legal.begin(), legal.end(), serves)) continue;
    // Only the first one is reported in words.
    incomplete.add(incomplete.count != 0
                       ? std::string{}
                       : fmt::format("{}: the list of the ports {:x}\n  incomplete list (joinable ports: {}): nothing "
                                     "in it is as good as\n    {}",
                                     file, ports, listed(recoloring.survey.joined, after.ports()),
                                     drawn(after, recoloring.colors)));
  }
}

}  // namespace restrip::verify
