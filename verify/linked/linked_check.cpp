#include "linked/linked_check.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "definition/definition.hpp"
#include "judge/report.hpp"

namespace restrip::verify {
namespace {

/// Checks the lists of one section in every world.
class WorldCheck {
 public:
  WorldCheck(const LinkedTask& task, LinkedCheck& check)
      : task_(task),
        after_(task.section->operations.front().after),
        worlds_(worlds_of(Constraint::strips, after_.ports())),
        in_worlds_(after_, Constraint::strips, worlds_),
        check_(check) {}

  /// Checks that the first alternative that is valid in a world is as good as the first valid recolouring.
  void check(Mask ports, const std::vector<Recoloring>& recolorings, List list) {
    std::vector<const Recoloring*> in_order;
    for (const Recoloring& recoloring : recolorings)
      if (recoloring.survey.valid) in_order.push_back(&recoloring);
    std::stable_sort(in_order.begin(), in_order.end(),
                     [](const Recoloring* one, const Recoloring* other) { return one->merit > other->merit; });
    for (std::size_t world = 0; world < worlds_.size(); ++world) {
      if (!is_subset(worlds_[world].ports, ports)) continue;
      ++check_.worlds;
      const auto best = std::find_if(in_order.begin(), in_order.end(), [&](const Recoloring* recoloring) {
        return in_worlds_.valid(recoloring->colors, world);
      });
      const auto row = std::find_if(list.begin(), list.end(), [&](const Alternative& alternative) {
        return in_worlds_.valid({alternative.inner, ports}, world);
      });
      const auto fail = [&](const std::string& what) {
        check_.best.add(fmt::format("{}: section {}, ports {:x}, {}\n  {}", task_.file, task_.section->position, ports,
                                    text_of(worlds_[world]), what));
      };
      if (row == list.end())
        fail("not the best: no alternative is sound");
      else if ((*best)->merit > recolorings[row->inner].merit)
        fail(fmt::format("not the best: the first sound alternative is line {}, \"{}\"; better:\n    {}", row->line,
                         row->text(), drawn(after_, (*best)->colors)));
    }
  }

 private:
  const LinkedTask& task_;
  const Side& after_;
  std::vector<World> worlds_;
  PatchInWorlds in_worlds_;
  LinkedCheck& check_;
};

using ClaimedNumbers = std::array<std::int64_t, linked_claim_words.size()>;

void check_claims(const LinkedTask& task, const ClaimedNumbers& counts, Failures& wrong) {
  for (std::size_t i = 0; i < counts.size(); ++i)
    if (const StatedClaim& claim = task.lists->claims[i]; claim.number != counts[i])
      wrong.add(fmt::format("{}:{}: \"claim {} {}\"\n  wrong claim: recounted {}", task.file, claim.line,
                            linked_claim_words[i], claim.number, counts[i]));
}

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

void check_linked(const LinkedTask& task, LinkedCheck& check) {
  ClaimedNumbers counts{};
  const Side& after = task.section->operations.front().after;
  ++check.sections;
  double last = thread_seconds();
  WorldCheck in_worlds(task, check);
  for (Mask ports = 0; ports < mask_count(after.ports()); ++ports) {
    const List list = task.lists->list(ports);
    const std::vector<Recoloring> recolorings = recolorings_of(after, ports);
    check.recolorings += recolorings.size();
    const auto length = static_cast<std::int64_t>(list.size());
    counts = {counts[0] + (list.empty() ? 0 : 1), counts[1] + length, std::max(counts[2], length)};
    check.rows += list.size();
    check_list(after, recolorings, ports, list, task.file, check.lists);
    const double listed = thread_seconds();
    check.listing_seconds += listed - last;
    in_worlds.check(ports, recolorings, list);
    last = thread_seconds();
    check.world_seconds += last - listed;
  }
  check_claims(task, counts, check.claims);
}

void report_linked(const LinkedFamily& family, const LinkedCheck& sum, const ClaimListener& listener) {
  std::uint64_t lists = 0;
  for (const Section& section : family.local.sections) lists += mask_count(section.ports);
  const auto report = [&](const std::string& claim, const std::string& method, std::uint64_t cases, double seconds,
                          const Failures& failures) {
    listener({family.name, claim, method, cases, seconds, failures.count, failures.first});
  };
  const auto of = [&](ListClaim claim) { return sum.lists[static_cast<std::size_t>(claim)]; };

  report("every port mask has its list", "all port masks", lists, 0, of(ListClaim::present));
  report("every alternative is legal", "degrees counted, cycles looked for", sum.rows, 0, of(ListClaim::legal));
  report("lists are in order of preference", "solid edges, isolated triangles counted", sum.rows, 0,
         of(ListClaim::ordered));
  report("no alternative is covered by an earlier one", "ports joined compared", sum.rows, 0, of(ListClaim::uncovered));
  report("lists are complete", "all recolourings, ports joined compared", sum.recolorings, sum.listing_seconds,
         of(ListClaim::complete));
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
