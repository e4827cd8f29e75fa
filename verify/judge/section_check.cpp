#include "judge/section_check.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace restrip::verify {
namespace {

std::string at_row(const CheckedSection& checked, const Row& row) {
  return fmt::format("{}:{}: \"{}\"\n  section {}: ", checked.file, row.line, row.text(), checked.section.position);
}

std::string fault_of_copy(const Row& row, const CheckedSection& checked, const Symmetries& symmetries) {
  if (!symmetries.allows(row.by)) return "wrong witness: no symmetry moves the ports in this way";
  const Key image = moved(row.key, row.by);
  const Row* const rule = checked.rows.row_of(image);
  if (rule == nullptr || rule->copy)
    return fmt::format("wrong witness: it takes the key to {:x} {:x}, which has no rule row", image.ports,
                       image.joined.bits);
  if (!symmetries.carries(row.by, row.after, rule->after))
    return fmt::format(
        "wrong witness: no symmetry with this permutation of ports maps the recolouring to the one in line {}",
        rule->line);
  return {};
}

/// For each row, the smallest key with a row in its orbit. Images without a row are followed too: if a section serves
/// several positions, no configuration may have them. Missing rows are reported by another claim.
std::vector<Key> smallest_keys(const SectionRows& rows, const Symmetries& symmetries) {
  std::map<Key, Key> smallest;
  std::vector<Key> result;
  for (const Row& row : rows.rows) {
    if (!smallest.contains(row.key)) {
      std::vector<Key> orbit = {row.key};
      std::set<Key> seen = {row.key};
      for (std::size_t i = 0; i < orbit.size(); ++i)
        for (const Symmetry& symmetry : symmetries.generators())
          if (const Key image = moved(orbit[i], symmetry.ports); seen.insert(image).second) orbit.push_back(image);
      const Key first =
          *std::find_if(seen.begin(), seen.end(), [&](const Key& key) { return rows.row_of(key) != nullptr; });
      for (const Key& key : orbit) smallest.emplace(key, first);
    }
    result.push_back(smallest.at(row.key));
  }
  return result;
}

using Numbers8 = std::array<std::int64_t, claim_words.size()>;

Numbers8 recounted(const CheckedSection& checked) {
  std::array<std::uint64_t, 5> sums{};
  std::optional<int> worst_strips;
  std::optional<int> worst_isolated;
  std::set<Key> keys;
  for (const PositionCheck& position : checked.positions) {
    const std::array<std::uint64_t, 5> own = {position.configurations, position.valid, position.merged.all,
                                              position.merged.valid, position.costing};
    for (std::size_t i = 0; i < sums.size(); ++i) sums[i] += own[i];
    worst_strips = std::max(worst_strips, position.worst_strips);
    worst_isolated = std::max(worst_isolated, position.worst_isolated);
    keys.insert(position.keys.begin(), position.keys.end());
  }
  const auto number = [](std::uint64_t count) { return static_cast<std::int64_t>(count); };
  return {number(sums[0]),     number(sums[1]), number(sums[2]),          number(sums[3]),
          number(keys.size()), number(sums[4]), worst_strips.value_or(0), worst_isolated.value_or(0)};
}

}  // namespace

Failures extra_rows(const CheckedSection& checked) {
  Failures failures;
  for (std::size_t i = 0; i < checked.rows.rows.size(); ++i)
    if (std::none_of(checked.positions.begin(), checked.positions.end(),
                     [&](const PositionCheck& position) { return position.row_used[i]; }))
      failures.add(at_row(checked, checked.rows.rows[i]) + "extra row: no valid configuration has this key\n");
  return failures;
}

Failures wrong_copies(const CheckedSection& checked, const Symmetries& symmetries) {
  Failures failures;
  const std::vector<Key> smallest = smallest_keys(checked.rows, symmetries);
  for (std::size_t i = 0; i < checked.rows.rows.size(); ++i) {
    const Row& row = checked.rows.rows[i];
    std::string fault;
    const bool smallest_is_rule = row.copy != (smallest[i] == row.key);
    if (!smallest_is_rule && row.copy)
      fault = "wrong representative: the smallest key of its orbit must be a rule, not a copy";
    else if (!smallest_is_rule)
      fault = fmt::format("wrong representative: {:x} {:x} is a smaller key of this orbit, so the row must be a copy",
                          smallest[i].ports, smallest[i].joined.bits);
    else if (row.copy)
      fault = fault_of_copy(row, checked, symmetries);
    if (!fault.empty()) failures.add(fmt::format("{}{}\n", at_row(checked, row), fault));
  }
  return failures;
}

Failures wrong_claims(const CheckedSection& checked) {
  const Numbers8 counted = recounted(checked);
  Failures failures;
  for (std::size_t i = 0; i < claim_words.size(); ++i) {
    const StatedClaim& claim = checked.rows.claims[i];
    if (claim.number != counted[i])
      failures.add(fmt::format("{}:{}: \"claim {} {}\"\n  wrong claim: recounted {}\n", checked.file, claim.line,
                               claim_words[i], claim.number, counted[i]));
  }
  return failures;
}

void tally_reasons(const CheckedSection& checked, ReasonTally& tally) {
  for (std::size_t i = 0; i < checked.rows.rows.size(); ++i) {
    const Row& row = checked.rows.rows[i];
    if (row.reason) {
      ++tally.rules;
      const std::size_t cases = row.reason->leaves();
      tally.trees += cases > 1 ? 1U : 0U;
      tally.most_cases = std::max(tally.most_cases, cases);
    }
    for (const PositionCheck& position : checked.positions) {
      if (position.reason_faults[i].empty()) continue;
      tally.wrong.add(fmt::format("{}wrong reason: {}\n", at_row(checked, row), position.reason_faults[i]));
      break;
    }
  }
}

}  // namespace restrip::verify
