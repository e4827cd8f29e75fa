#include "linked/linked_check.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "judge/position_check.hpp"

namespace restrip::verify {
namespace {

/// The lists of one section beside everything that may lie outside.
class BesideCheck {
 public:
  BesideCheck(const LinkedTask& task, LinkedCheck& check)
      : task_(task),
        operation_(task.section->operations.front()),
        table_(operation_.constraint, operation_.ports()),
        after_(operation_.after, most_solid(operation_.constraint), table_),
        check_(check) {
    for (const Operation& operation : task.section->operations) judges_.emplace_back(operation, table_);
  }

  void check(Mask ports, const std::vector<Recoloring>& recolorings, List list) {
    const std::vector<World>& worlds = table_.worlds().of(ports);
    check_.worlds += worlds.size();
    for (const Alternative& row : list)
      if (recolorings[row.inner].survey.valid) check_condition(recolorings[row.inner], row, worlds);
    for (std::size_t world = 0; world < worlds.size(); ++world) check_best(ports, world, recolorings, list);
    for (const RuleJudge& judge : judges_)
      for (const std::uint32_t number : judge.before().of_ports(ports)) check_local(judge, number, recolorings, list);
  }

 private:
  /// The worlds in which the recolouring is sound; null when it is in none.
  const NumberSet* sound(Colors recoloring) const {
    const std::uint32_t number = after_.class_of(recoloring);
    return number == Colorings::not_valid ? nullptr : &table_.classes()[after_.classes()[number].fit_class].worlds;
  }
  bool sound_in(Colors recoloring, std::size_t world) const {
    const NumberSet* const worlds = sound(recoloring);
    return worlds != nullptr && worlds->has(world);
  }

  /// Whoever follows the pairs of a row, as the runtime does, must find what a look at the world finds.
  void check_condition(const Recoloring& recoloring, const Alternative& row, const std::vector<World>& worlds) {
    check_.beside += worlds.size();
    for (std::size_t world = 0; world < worlds.size(); ++world) {
      const PortPairs outside = pairs_of(worlds[world]);
      const bool is_sound = sound_in(recoloring.colors, world);
      if (is_sound == close_a_cycle(recoloring.survey.joined, outside, operation_.ports()))
        check_.condition.add(fmt::format("{}:{}: \"{}\" is {} where strips outside join {}, but its pairs are {}",
                                         task_.file, row.line, row.text(), is_sound ? "sound" : "not sound",
                                         listed(outside, operation_.ports()),
                                         listed(recoloring.survey.joined, operation_.ports())));
    }
  }

  /// No recolouring that is preferred to the first sound row is sound in the world. Every one is tried.
  void check_best(Mask ports, std::size_t world, const std::vector<Recoloring>& recolorings, List list) {
    const auto fail = [&](const std::string& what) {
      check_.best.add(fmt::format("{}: section {}, ports {:x}, joined outside: {}\n  {}", task_.file,
                                  task_.section->position, ports,
                                  listed(pairs_of(table_.worlds().of(ports)[world]), operation_.ports()), what));
    };
    const auto row = std::find_if(list.begin(), list.end(), [&](const Alternative& alternative) {
      return sound_in({alternative.inner, ports}, world);
    });
    if (row == list.end()) return fail("not the best: no alternative is sound");
    for (const Recoloring& recoloring : recolorings)
      if (recoloring.merit > recolorings[row->inner].merit && sound_in(recoloring.colors, world))
        return fail(fmt::format("not the best: the first sound alternative is line {}, \"{}\"; better:\n    {}",
                                row->line, row->text(), drawn(operation_.after, recoloring.colors)));
  }

  /// Where only the colours before are known, every world that these fit may lie outside.
  void check_local(const RuleJudge& judge, std::uint32_t number, const std::vector<Recoloring>& recolorings,
                   List list) {
    const ColoringClass& configurations = judge.before().classes()[number];
    check_.configurations += configurations.colorings;
    const NumberSet& possible = table_.classes()[configurations.fit_class].worlds;
    const auto row = std::find_if(list.begin(), list.end(), [&](const Alternative& alternative) {
      const NumberSet* const worlds = sound({alternative.inner, configurations.first.ports});
      return worlds != nullptr && possible.within(*worlds);
    });
    const Row* const rule = task_.local->row_of(judge.key_of_class(number));
    const auto fail = [&](const std::string& what) {
      check_.local.add(fmt::format("{}: {}, inner {:x}, ports {:x}\n    {}\n  {}", task_.file, judge.operation().name(),
                                   configurations.first.inner, configurations.first.ports,
                                   drawn(judge.operation().before, configurations.first), what),
                       configurations.colorings);
    };
    if (rule == nullptr)
      fail(fmt::format("not the local rule: {} has none", task_.local_file));
    else if (row == list.end())
      fail("not the local rule: no alternative is sound beside all that is possible");
    else if (recolorings[row->inner].merit != recolorings[rule->after.inner].merit)
      fail(fmt::format("not the local rule: \"{}\" in line {} is not as good as \"{}\" in {}:{}, or better",
                       row->text(), row->line, rule->text(), task_.local_file, rule->line));
  }

  const LinkedTask& task_;
  const Operation& operation_;
  FitTable table_;
  Colorings after_;
  std::vector<RuleJudge> judges_;  ///< one for each position of the section
  LinkedCheck& check_;
};

using ClaimedNumbers = std::array<std::int64_t, linked_claim_words.size()>;

void check_claims(const LinkedTask& task, const ClaimedNumbers& counts, Failures& wrong) {
  for (std::size_t i = 0; i < counts.size(); ++i)
    if (const StatedClaim& claim = task.lists->claims[i]; claim.number != counts[i])
      wrong.add(fmt::format("{}:{}: \"claim {} {}\"\n  wrong claim: recounted {}", task.file, claim.line,
                            linked_claim_words[i], claim.number, counts[i]));
}

/// The partner of each port, four bits each: itself where it has none, as have those behind the patch's own.
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
  const Operation& operation = task.section->operations.front();
  const Side& after = operation.after;
  ++check.sections;
  check.searched = check.searched && searched(operation);
  double last = thread_seconds();
  std::optional<BesideCheck> beside;
  if (searched(operation)) beside.emplace(task, check);
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
    if (beside) beside->check(ports, recolorings, list);
    last = thread_seconds();
    check.beside_seconds += last - listed;
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
  const std::string limit = sum.searched ? "" : fmt::format(", k <= {}", most_searched_ports);
  const auto of = [&](ListClaim claim) { return sum.lists[static_cast<std::size_t>(claim)]; };

  report("every port mask has its list", "all port masks", lists, 0, of(ListClaim::present));
  report("every alternative is legal", "degrees counted, cycles looked for", sum.rows, 0, of(ListClaim::legal));
  report("lists are in order of preference", "solid edges, isolated triangles counted", sum.rows, 0,
         of(ListClaim::ordered));
  report("no alternative is covered by an earlier one", "ports joined compared", sum.rows, 0, of(ListClaim::uncovered));
  report("lists are complete", "all recolourings, ports joined compared", sum.recolorings, sum.listing_seconds,
         of(ListClaim::complete));
  report("an alternative is sound just when its pairs say so", "patch and outside as one graph, all worlds" + limit,
         sum.beside, 0, sum.condition);
  report("beside any outside nothing beats the first sound one", "the same graphs, search of all recolourings" + limit,
         sum.worlds, sum.beside_seconds, sum.best);
  report("where only colours are known it equals the local rule",
         fmt::format("the same graphs; {}.cert{}", family.local.name, limit), sum.configurations, 0, sum.local);
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
