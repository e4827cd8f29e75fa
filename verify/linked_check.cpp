#include "linked_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "draw.hpp"
#include "mutants.hpp"
#include "operation_check.hpp"

namespace restrip::verify {
namespace {

/// One bit for each matching outside.
using Worlds = std::vector<bool>;

bool within(const Worlds& part, const Worlds& whole) {
  for (std::size_t i = 0; i < part.size(); ++i)
    if (part[i] && !whole[i]) return false;
  return true;
}

std::vector<World> worlds_around(const Patch& patch, Mask ports, const std::vector<PortPairs>& matchings) {
  std::vector<World> worlds;
  worlds.reserve(matchings.size());
  for (const PortPairs outside : matchings) worlds.emplace_back(patch, ports, outside);
  return worlds;
}

/// The lists of one section beside everything that may lie outside.
class BesideCheck {
 public:
  BesideCheck(const LinkedTask& task, LinkedCheck& check)
      : task_(task), after_(task.section->operations.front().after), check_(check) {
    for (const Row& row : task.local->rows) local_.emplace(row.key, &row);
  }

  void check(Mask ports, const std::vector<SurveyedColoring>& recolorings, List list) {
    const std::vector<PortPairs> matchings = matchings_of(ports);
    const std::vector<World> worlds = worlds_around(after_, ports, matchings);
    std::vector<Worlds> sound;  // for each row where it is
    for (const Alternative& row : list) {
      sound.emplace_back();
      for (const World& world : worlds) sound.back().push_back(world.look(row.inner).sound);
      check_condition(recolorings[row.inner], row, matchings, sound.back());
    }
    check_.worlds += worlds.size();
    for (std::size_t q = 0; q < worlds.size(); ++q) {
      Worlds one(worlds.size());
      one[q] = true;
      check_best(ports, worlds[q], matchings[q], first_sound(list, sound, one));
    }
    for (const Operation& operation : task_.section->operations)
      check_local(operation, ports, recolorings, matchings, list, sound);
  }

 private:
  /// The first row that is sound in all these worlds; null when there is none.
  static const Alternative* first_sound(List list, const std::vector<Worlds>& sound, const Worlds& possible) {
    for (std::size_t i = 0; i < list.size(); ++i)
      if (within(possible, sound[i])) return &list[i];
    return nullptr;
  }

  /// Whoever follows the pairs of a row, as the runtime does, must find what a look at the world finds.
  void check_condition(const SurveyedColoring& recoloring, const Alternative& row,
                       const std::vector<PortPairs>& matchings, const Worlds& sound) {
    if (!recoloring.survey.valid) return;
    check_.beside += matchings.size();
    for (std::size_t q = 0; q < matchings.size(); ++q)
      if (sound[q] == close_a_cycle(recoloring.survey.joined, matchings[q], after_.ports()))
        check_.condition.add(fmt::format("{}:{}: \"{}\" is {} where strips outside join {}, but its pairs are {}",
                                         task_.file, row.line, row.text(), sound[q] ? "sound" : "not sound",
                                         listed(matchings[q], after_.ports()),
                                         listed(recoloring.survey.joined, after_.ports())));
  }

  /// No recolouring that is preferred to the row is sound in the world. Every one is tried.
  void check_best(Mask ports, const World& world, PortPairs outside, const Alternative* row) {
    const auto fail = [&](const std::string& what) {
      check_.best.add(fmt::format("{}: section {}, ports {:x}, joined outside: {}\n  {}", task_.file,
                                  task_.section->position, ports, listed(outside, after_.ports()), what));
    };
    if (row == nullptr) return fail("not the best: no alternative is sound");
    const unsigned solid = solid_count(row->inner);
    const int isolated = world.look(row->inner).isolated;
    const unsigned at_least = isolated == 0 ? solid + 1 : solid;  // what is preferred has so many solid edges
    for (Mask inner = 0; inner < mask_count(after_.inner_edges()); ++inner) {
      if (solid_count(inner) < at_least || mutated(Mutant::beside_first_is_best)) continue;
      const World::View view = world.look(inner);
      const bool lonely =
          solid_count(inner) == solid && (view.isolated >= isolated || mutated(Mutant::beside_ignore_isolated));
      if (view.sound && !lonely)
        return fail(
            fmt::format("not the best: the first sound alternative is line {}, \"{}\"; better:\n{}    inner {:x}",
                        row->line, row->text(), drawn(after_, {inner, ports}, "    "), inner));
    }
  }

  /// Where only the colours before are known, whatever closes no cycle with them may lie outside.
  void check_local(const Operation& operation, Mask ports, const std::vector<SurveyedColoring>& recolorings,
                   const std::vector<PortPairs>& matchings, List list, const std::vector<Worlds>& sound) {
    const std::vector<World> worlds = worlds_around(operation.before, ports, matchings);
    for (Mask inner = 0; inner < mask_count(operation.before.inner_edges()); ++inner) {
      const Coloring before{inner, ports};
      const Survey own = survey(operation.before, before);
      if (!own.valid) continue;
      ++check_.configurations;
      Worlds possible;
      for (const World& world : worlds)
        possible.push_back(world.look(inner).sound || mutated(Mutant::local_any_outside));
      const Alternative* row = first_sound(list, sound, possible);
      const auto rule = local_.find(key_of(operation, before, own));
      const auto fail = [&](const std::string& what) {
        check_.local.add(fmt::format("{}: {}, inner {:x}, ports {:x}\n{}  {}", task_.file, operation.name(), inner,
                                     ports, drawn(operation.before, before, "    "), what));
      };
      if (rule == local_.end())
        fail(fmt::format("not the local rule: {} has none", task_.local_file));
      else if (row == nullptr)
        fail("not the local rule: no alternative is sound beside all that is possible");
      else if (merit(recolorings[row->inner]) != merit(recolorings[rule->second->after.inner]))
        fail(fmt::format("not the local rule: \"{}\" in line {} is not as good as \"{}\" in {}:{}, or better",
                         row->text(), row->line, text_of(*rule->second, false), task_.local_file, rule->second->line));
    }
  }

  static Merit merit(const SurveyedColoring& recoloring) {
    if (mutated(Mutant::local_unequal)) return {};
    return merit_of(recoloring.survey, recoloring.colors, recoloring.colors.ports);
  }

  const LinkedTask& task_;
  const Patch& after_;
  LinkedCheck& check_;
  std::map<Key, const Row*> local_;
};

void check_claims(const LinkedTask& task, LinkedCheck& check) {
  for (std::size_t i = 0; i < linked_claim_words.size(); ++i) {
    const StatedClaim& claim = task.lists->claims[i];
    if (claim.number != check.counts[i] && !mutated(Mutant::lists_skip_claims))
      check.claims.add(fmt::format("{}:{}: \"claim {} {}\"\n  wrong claim: recounted {}", task.file, claim.line,
                                   linked_claim_words[i], claim.number, check.counts[i]));
  }
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

LinkedCheck check_linked(const LinkedTask& task) {
  LinkedCheck check;
  const Patch& after = task.section->operations.front().after;
  check.searched = searched(task.section->operations.front());
  BesideCheck beside(task, check);
  double last = thread_seconds();
  for (Mask ports = 0; ports < mask_count(after.ports()); ++ports) {
    const List list = task.lists->list(ports);
    const std::vector<SurveyedColoring> recolorings = recolorings_of(after, ports);
    check.recolorings += recolorings.size();
    check.counts[0] += list.empty() ? 0 : 1;
    check.counts[1] += static_cast<std::int64_t>(list.size());
    check.counts[2] = std::max(check.counts[2], static_cast<std::int64_t>(list.size()));
    check_list(after, recolorings, ports, list, task.file, check.lists);
    const double listed = thread_seconds();
    check.listing_seconds += listed - last;
    if (check.searched) beside.check(ports, recolorings, list);
    last = thread_seconds();
    check.beside_seconds += last - listed;
  }
  check_claims(task, check);
  return check;
}

std::vector<std::string> dump_of(const Section& section, const SectionLists& lists, unsigned places) {
  const Patch& after = section.operations.front().after;
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
