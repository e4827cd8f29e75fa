#include "linked/linked_check.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "definition/definition.hpp"
#include "judge/report.hpp"

namespace restrip::verify {
namespace {

/// The partner of each port, four bits each: itself if it has none, or if it is beyond the ports of the patch.
std::uint64_t partners(PortPairs joined, unsigned ports, unsigned places) {
  std::uint64_t all = 0;
  for (unsigned i = places; i-- > 0;) {
    unsigned partner = i;
    for (unsigned j = 0; j < ports; ++j)
      if (i < ports && j != i && joined.has(i, j)) partner = j;
    all = all * 16 + partner;
  }
  return all;
}

}  // namespace

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
  const auto fail = [&](Failures& claim, const Alternative& row, const std::string& what) {
    claim.add(
        fmt::format("{}:{}: \"{}\"\n    {}\n  {}", file, row.line, row.text(), drawn(after, {row.inner, ports}), what));
  };
  if (list.empty()) failures.present.add(fmt::format("{}: missing list: the ports {:x} have no row", file, ports));
  struct Legal {
    const Alternative* row;
    const Recoloring* own;
  };
  std::vector<Legal> legal;
  for (const Alternative& row : list) {
    const Recoloring& own = recolorings[row.inner];
    if (!own.survey.valid) {
      fail(failures.legal, row,
           "illegal alternative: " + invalid_because(after, own.colors, most_solid(Constraint::strips)));
      continue;
    }
    if (!legal.empty() && legal.back().own->merit < own.merit)
      fail(failures.ordered, row,
           fmt::format("out of order: it is preferred to the row before it, in line {}", legal.back().row->line));
    const auto cover = std::find_if(legal.begin(), legal.end(), [&](const Legal& earlier) {
      return earlier.own->survey.joined.within(own.survey.joined);
    });
    if (cover != legal.end())
      fail(failures.uncovered, row,
           fmt::format("covered alternative: it joins {}; line {} is preferred and joins no other ports: {}",
                       listed(own.survey.joined, after.ports()), cover->row->line,
                       listed(cover->own->survey.joined, after.ports())));
    legal.push_back({&row, &own});
  }
  for (const Recoloring& recoloring : recolorings) {
    if (!recoloring.survey.valid) continue;
    // Sound wherever the recolouring is sound, and as good.
    const auto serves = [&](const Legal& row) {
      return row.own->merit >= recoloring.merit && row.own->survey.joined.within(recoloring.survey.joined);
    };
    if (std::any_of(legal.begin(), legal.end(), serves)) continue;
    // Only the first one is reported in words.
    failures.complete.add(
        failures.complete.count != 0
            ? std::string{}
            : fmt::format("{}: the list of the ports {:x}\n  incomplete list (joinable ports: {}): nothing "
                          "in it is as good as\n    {}",
                          file, ports, listed(recoloring.survey.joined, after.ports()),
                          drawn(after, recoloring.colors)));
  }
}

void check_linked(const Section& section, const SectionLists& lists, const std::string& file, LinkedCheck& check) {
  double last = thread_seconds();
  const Side& after = section.operations.front().after;
  const std::vector<World> worlds = worlds_of(Constraint::strips, after.ports());
  const PatchInWorlds in_worlds(after, Constraint::strips, worlds);
  std::array<std::int64_t, linked_claim_words.size()> counts{};
  ++check.sections;
  check.rows += lists.rows.size();
  for (Mask ports = 0; ports < mask_count(after.ports()); ++ports) {
    const List list = lists.list(ports);
    const std::vector<Recoloring> recolorings = recolorings_of(after, ports);
    check.recolorings += recolorings.size();
    const auto length = static_cast<std::int64_t>(list.size());
    counts = {counts[0] + (list.empty() ? 0 : 1), counts[1] + length, std::max(counts[2], length)};
    check_list(after, recolorings, ports, list, file, check.lists);
    const double listed = thread_seconds();
    check.listing_seconds += listed - last;

    // In each world the first alternative that is valid there must be as good as the first valid recolouring.
    std::vector<const Recoloring*> in_order;
    for (const Recoloring& recoloring : recolorings)
      if (recoloring.survey.valid) in_order.push_back(&recoloring);
    std::stable_sort(in_order.begin(), in_order.end(),
                     [](const Recoloring* one, const Recoloring* other) { return one->merit > other->merit; });
    for (std::size_t world = 0; world < worlds.size(); ++world) {
      if (!is_subset(worlds[world].ports, ports)) continue;
      ++check.worlds;
      const auto best = std::find_if(in_order.begin(), in_order.end(), [&](const Recoloring* recoloring) {
        return in_worlds.valid(recoloring->colors, world);
      });
      const auto row = std::find_if(list.begin(), list.end(), [&](const Alternative& alternative) {
        return in_worlds.valid({alternative.inner, ports}, world);
      });
      const auto fail = [&](const std::string& what) {
        check.best.add(fmt::format("{}: section {}, ports {:x}, {}\n  {}", file, section.position, ports,
                                   text_of(worlds[world]), what));
      };
      if (row == list.end())
        fail("not the best: no alternative is sound");
      else if ((*best)->merit > recolorings[row->inner].merit)
        fail(fmt::format("not the best: the first sound alternative is line {}, \"{}\"; better:\n    {}", row->line,
                         row->text(), drawn(after, (*best)->colors)));
    }
    last = thread_seconds();
    check.world_seconds += last - listed;
  }
  for (std::size_t i = 0; i < counts.size(); ++i)
    if (const StatedClaim& claim = lists.claims[i]; claim.number != counts[i])
      check.claims.add(fmt::format("{}:{}: \"claim {} {}\"\n  wrong claim: recounted {}", file, claim.line,
                                   linked_claim_words[i], claim.number, counts[i]));
}

void report_linked(const LinkedFamily& family, const LinkedCheck& sum, const ClaimListener& listener) {
  std::uint64_t lists = 0;
  for (const Section& section : family.local.sections) lists += mask_count(section.ports);
  const auto report = [&](const std::string& claim, const std::string& method, std::uint64_t cases, double seconds,
                          const Failures& failures) {
    listener({family.name, claim, method, cases, seconds, failures});
  };

  report("every port mask has its list", "all port masks", lists, 0, sum.lists.present);
  report("every alternative is legal", "degrees counted, cycles looked for", sum.rows, 0, sum.lists.legal);
  report("lists are in order of preference", "solid edges, isolated triangles counted", sum.rows, 0, sum.lists.ordered);
  report("no alternative is covered by an earlier one", "ports joined compared", sum.rows, 0, sum.lists.uncovered);
  report("lists are complete", "all recolourings, ports joined compared", sum.recolorings, sum.listing_seconds,
         sum.lists.complete);
  report("in every world the first sound one is best", "definition, all worlds", sum.worlds, sum.world_seconds,
         sum.best);
  report("the stated numbers", "recounted", linked_claim_words.size() * sum.sections, 0, sum.claims);
}

std::vector<std::string> dump_of(const Section& section, const SectionLists& lists, unsigned places) {
  const Side& after = section.operations.front().after;
  std::vector<std::string> lines;
  for (Mask ports = 0; ports < mask_count(section.ports); ++ports) {
    lines.push_back(fmt::format("{:x}", ports));
    for (const Alternative& row : lists.list(ports))
      lines.back() += fmt::format(" {:x} {:x}", row.inner,
                                  partners(survey(after, {row.inner, ports}).joined, section.ports, places));
  }
  return lines;
}

}  // namespace restrip::verify
