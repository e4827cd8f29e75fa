#include "judgment.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "draw.hpp"
#include "mutants.hpp"

namespace restrip::verify {
namespace {

bool in_search(const PortSlice& slice, const SurveyedColoring& recoloring, const Patch& after) {
  if (mutated(Mutant::skip_last_recoloring)) return &recoloring != &slice.after.back();
  if (mutated(Mutant::ignore_chord_recolorings))
    return !(after.chord() && is_solid(recoloring.colors.inner, *after.chord()));
  return true;
}

bool pairing_allowed(PortPairs after, PortPairs before) {
  return mutated(Mutant::drop_pairing) || after.within(before);
}

/// The greatest merit found, and who has it.
struct Best {
  Merit merit{-1, 0, 0};
  const SurveyedColoring* recoloring = nullptr;
};

Best search(const PortSlice& slice, PortPairs joined_before, const Patch& after) {
  Best best;
  for (const SurveyedColoring& recoloring : slice.after) {
    if (!recoloring.survey.valid || !pairing_allowed(recoloring.survey.joined, joined_before)) continue;
    if (active_mutant != Mutant::none && !in_search(slice, recoloring, after)) continue;
    const Merit merit = merit_of(recoloring.survey, recoloring.colors, slice.ports);
    if (merit > best.merit) best = {merit, &recoloring};
  }
  return best;
}

const SurveyedColoring* find(const PortSlice& slice, Coloring after, bool gives_ports_up) {
  if (!gives_ports_up) return &slice.after[after.inner];
  const auto found = std::find_if(slice.after.begin(), slice.after.end(),
                                  [&](const SurveyedColoring& recoloring) { return recoloring.colors == after; });
  return found == slice.after.end() ? nullptr : &*found;
}

/// `recoloring` is null when a dashed port would become solid.
bool is_sound(const SurveyedColoring* recoloring, PortPairs joined_before) {
  if (recoloring == nullptr) return false;
  if (!recoloring->survey.valid) return mutated(Mutant::skip_own_validity);
  return mutated(Mutant::skip_own_pairing) || pairing_allowed(recoloring->survey.joined, joined_before);
}

std::string unsoundness(const SurveyedColoring* recoloring, PortPairs joined_before, const Patch& after) {
  if (recoloring == nullptr) return "it makes a dashed port solid";
  if (!recoloring->survey.valid) return fault_of(after, recoloring->colors);
  const PortPairs foreign{recoloring->survey.joined.bits & ~joined_before.bits};
  return fmt::format("it joins ports that were not joined before: {}", listed(foreign, after.ports()));
}

}  // namespace

Judge::Judge(const Section& section, const SectionRows& rows, const Operation& operation, std::string file)
    : section_(section), rows_(rows), operation_(operation), file_(std::move(file)) {
  row_of_key_.resize(mask_count(section.ports + section.key_bits));
  for (const Row& row : rows.rows) row_of_key_[concatenated(row.key.ports, row.key.second, section.key_bits)] = &row;
  judgment_.row_used.resize(rows.rows.size());
  if (!searched(operation)) own_.resize(rows.rows.size());
  judgment_.answers.resize(mask_count(operation.before.inner_edges() + section.ports), not_valid);
}

void Judge::judge(const PortSlice& slice) {
  judgment_.configurations += slice.before.size();
  for (const SurveyedColoring& configuration : slice.before) {
    if (!configuration.survey.valid) continue;
    if (mutated(Mutant::skip_first_configuration) && slice.ports == 0 && configuration.colors.inner == 0) continue;
    ++judgment_.valid;
    judge_configuration(slice, configuration);
  }
}

const SurveyedColoring* Judge::own_recoloring(const PortSlice& slice, const Row& row) {
  if (searched(operation_)) return find(slice, row.after, operation_.gives_ports_up);
  std::optional<SurveyedColoring>& own = own_[static_cast<std::size_t>(&row - rows_.rows.data())];
  if (!own) own = {row.after, survey(operation_.after, row.after)};
  return &*own;
}

void Judge::judge_configuration(const PortSlice& slice, const SurveyedColoring& configuration) {
  Answer& answer = judgment_.answers[concatenated(configuration.colors.inner, slice.ports, section_.ports)];
  answer = no_row;

  const Key key = key_of(operation_, configuration.colors, configuration.survey);
  const Row* row = row_of_key_[concatenated(key.ports, key.second, section_.key_bits)];
  if (row == nullptr) {
    if (!mutated(Mutant::accept_missing))
      fail(RowClaim::covered, slice, configuration, row,
           [&] { return fmt::format("missing row: no row has the key {:x} {:x}", key.ports, key.second); });
    return;
  }
  judgment_.row_used[static_cast<std::size_t>(row - rows_.rows.data())] = true;
  answer = packed(row->after, operation_);
  ++judgment_.with_row;

  const PortPairs joined_before = configuration.survey.joined;
  const SurveyedColoring* own = own_recoloring(slice, *row);
  if (!is_sound(own, joined_before)) {
    fail(RowClaim::sound, slice, configuration, row,
         [&] { return "unsound row: " + unsoundness(own, joined_before, operation_.after); });
    return;
  }
  ++judgment_.with_sound_row;
  const Merit merit = merit_of(own->survey, own->colors, slice.ports);
  if (searched(operation_)) search_better(slice, configuration, *row, merit);

  const Change change = change_of(operation_, configuration, merit);
  judgment_.costing += change.strips >= 1 ? 1U : 0U;
  judgment_.worst_strips = std::max(judgment_.worst_strips.value_or(change.strips), change.strips);
  judgment_.worst_isolated = std::max(judgment_.worst_isolated.value_or(change.isolated), change.isolated);
}

/// Holds the row of a configuration, which has this merit, against all recolourings.
void Judge::search_better(const PortSlice& slice, const SurveyedColoring& configuration, const Row& row, Merit merit) {
  judgment_.pairs += slice.after.size();
  const Best best = search(slice, configuration.survey.joined, operation_.after);
  const auto inferior = [&](RowClaim claim, const char* crime, int found, const char* what, int possible) {
    fail(claim, slice, configuration, &row, [&] {
      return fmt::format("{}: {} {} where {} are possible; better:\n{}", crime, found, what, possible,
                         drawn(operation_.after, best.recoloring->colors, "    "));
    });
  };
  const int slack = mutated(Mutant::strips_off_by_one) ? 1 : 0;
  const bool as_solid = merit.solid == best.merit.solid;
  const bool as_lonely = as_solid && merit.fewer_isolated == best.merit.fewer_isolated;
  if (merit.solid + slack < best.merit.solid)
    inferior(RowClaim::most_solid, "not optimal", merit.solid, "solid edges", best.merit.solid);
  else if (as_solid && merit.fewer_isolated < best.merit.fewer_isolated && !mutated(Mutant::ignore_isolated))
    inferior(RowClaim::fewest_isolated, "lonelier than need be", -merit.fewer_isolated, "isolated triangles",
             -best.merit.fewer_isolated);
  else if (as_lonely && merit.ports_kept < best.merit.ports_kept && !mutated(Mutant::ignore_ports_kept))
    inferior(RowClaim::most_ports_kept, "gives up ports", merit.ports_kept, "kept", best.merit.ports_kept);
}

std::string Judge::explained(const std::string& what, const PortSlice& slice, const SurveyedColoring& configuration,
                             const Row* row) const {
  const std::string place =
      row != nullptr ? fmt::format("{}:{}: \"{}\"", file_, row->line, text_of(*row, operation_.gives_ports_up))
                     : fmt::format("{}: section {}", file_, section_.position);
  std::string text =
      fmt::format("{}\n  {}, inner {:x}, ports {:x}\n  before:\n{}", place, operation_.name(),
                  configuration.colors.inner, slice.ports, drawn(operation_.before, configuration.colors, "    "));
  if (row != nullptr) text += fmt::format("  the row's recolouring:\n{}", drawn(operation_.after, row->after, "    "));
  return text + "  " + what;
}

}  // namespace restrip::verify
