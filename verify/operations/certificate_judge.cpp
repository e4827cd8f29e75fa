#include "certificate_judge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

#include "operation_mutants.hpp"

namespace restrip::verify::operations {
namespace {

std::string at_row(const OperationCertificate& certificate, const RuleRow& row) {
  return fmt::format("{}:{}: \"{}\"\n", certificate.file, row.line, row.text());
}

class RowChecker {
 public:
  RowChecker(RuleJudge& judge, const OperationCertificate& certificate) : judge_(judge), certificate_(certificate) {}

  RowCheck run() {
    const FitClasses& before = judge_.before();
    std::set<const RuleRow*> used;
    for (Mask both = 0; both < before.class_of_coloring.size(); ++both) {
      ++check_.configurations;
      if (before.class_of_coloring[both] == FitClasses::not_valid) continue;
      ++check_.valid;
      const Colors configuration{high_part(both, before.ports), low_part(both, before.ports)};
      const OperationKey key = key_of(judge_.operation(), configuration);
      if (const RuleRow* const row = certificate_.row_of(key)) {
        used.insert(row);
        judge_row(*row, configuration);
      } else if (!mutated(OperationMutant::accept_missing_rows)) {
        check_.missing.add(fmt::format("{}: no row for the key {:x} {:x} of\n    {}\n", certificate_.file, key.ports,
                                       key.joined.bits, drawn(judge_.operation().before, configuration)));
      }
    }
    for (const RuleRow& row : certificate_.rows)
      if (!used.contains(&row) && !mutated(OperationMutant::accept_extra_rows))
        check_.extra.add(at_row(certificate_, row) + "  extra row: no valid configuration has this key\n");
    return check_;
  }

 private:
  void judge_row(const RuleRow& row, Colors configuration) {
    const bool is_first = check_.with_row++ == 0;
    const Judged judged = judge_.judged(configuration, row.after);
    if (Failures* const failures = failures_of(judged)) {
      // Explaining takes longer than judging: only the first is shown.
      failures->add(failures->count != 0
                        ? std::string()
                        : at_row(certificate_, row) + judge_.explained(configuration, row.after, judged));
    }
    const OperationFile& operation = judge_.operation();
    const std::int64_t strips = strips_of(operation.after, row.after) - strips_of(operation.before, configuration);
    const std::int64_t given_up =
        mutated(OperationMutant::worst_without_ports) ? 0 : solid_count(configuration.ports & ~row.after.ports);
    const std::int64_t isolated =
        isolated_of(operation.after, row.after) + given_up - isolated_of(operation.before, configuration);
    check_.worst_strips = is_first ? strips : std::max(check_.worst_strips, strips);
    check_.worst_isolated = is_first ? isolated : std::max(check_.worst_isolated, isolated);
    if ((operation.constraint == Constraint::matching ? isolated : strips) > 0) ++check_.costing;
  }

  Failures* failures_of(const Judged& judged) {
    switch (judged.verdict) {
      case Verdict::right:
        return nullptr;
      case Verdict::wrong_ports:
        return &check_.wrong_ports;
      case Verdict::unsound:
        return &check_.unsound;
      case Verdict::not_best:
        break;
    }
    return &check_.not_best[judged.criterion];
  }

  RuleJudge& judge_;
  const OperationCertificate& certificate_;
  RowCheck check_;
};

std::vector<Mask> images_of_masks(const Permutation& permutation) {
  std::vector<Mask> images;
  for (Mask mask = 0; mask < mask_count(static_cast<unsigned>(permutation.size())); ++mask)
    images.push_back(moved(mask, permutation));
  return images;
}

/// Sets that are merged; each is known by its smallest member.
class MergedSets {
 public:
  explicit MergedSets(std::size_t size) : parent_(size) { std::iota(parent_.begin(), parent_.end(), Mask{0}); }
  Mask smallest(Mask member) {
    while (parent_[member] != member) member = parent_[member] = parent_[parent_[member]];
    return member;
  }
  void merge(Mask one, Mask other) {
    const Mask a = smallest(one);
    const Mask b = smallest(other);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<Mask> parent_;
};

std::string fault_of_copy_row(const RuleRow& row, const OperationCertificate& certificate,
                              const PatchSymmetries& symmetries) {
  if (mutated(OperationMutant::accept_any_witness)) return {};
  if (!symmetries.allows(row.by)) return "wrong witness: no symmetry moves the ports so";
  const OperationKey image = moved(row.key, row.by);
  const RuleRow* const rule = certificate.row_of(image);
  if (rule == nullptr || rule->copy)
    return fmt::format("wrong witness: it takes the key to {:x} {:x}, which has no rule row", image.ports,
                       image.joined.bits);
  if (!symmetries.carries(row.by, row.after, rule->after))
    return fmt::format("wrong witness: no symmetry that moves the ports so takes the recolouring to that of line {}",
                       rule->line);
  return {};
}

/// The smallest key of each orbit of the keys that have rows, by the place of the row. Images without a row are looked
/// at as well: such a row is missing, which another claim says.
std::vector<OperationKey> smallest_keys(const OperationCertificate& certificate, const PatchSymmetries& symmetries) {
  std::map<OperationKey, OperationKey> smallest;
  std::vector<OperationKey> result;
  for (const RuleRow& row : certificate.rows) {
    if (!smallest.contains(row.key)) {
      std::vector<OperationKey> orbit = {row.key};
      std::set<OperationKey> seen = {row.key};
      for (std::size_t i = 0; i < orbit.size(); ++i)
        for (const SideSymmetry& symmetry : symmetries.generators())
          if (const OperationKey image = moved(orbit[i], symmetry.ports); seen.insert(image).second)
            orbit.push_back(image);
      for (const OperationKey& key : orbit) smallest.emplace(key, *seen.begin());
    }
    result.push_back(smallest.at(row.key));
  }
  return result;
}

}  // namespace

OperationKey key_of(const OperationFile& operation, Colors configuration) {
  return {
      configuration.ports,
      joined_ports(operation.before, inner_graph(operation.before, configuration.inner).value(), configuration.ports)};
}

RowCheck check_rows(RuleJudge& judge, const OperationCertificate& certificate) {
  return RowChecker(judge, certificate).run();
}

KeyCheck check_keys(const RuleJudge& judge) {
  const FitClasses& before = judge.before();
  std::map<OperationKey, std::uint32_t> class_of_key;
  std::vector<std::optional<OperationKey>> key_of_class(before.classes.size());
  KeyCheck check;
  for (Mask both = 0; both < before.class_of_coloring.size(); ++both) {
    const std::uint32_t number = before.class_of_coloring[both];
    if (number == FitClasses::not_valid) continue;
    ++check.valid;
    const Colors configuration{high_part(both, before.ports), low_part(both, before.ports)};
    const OperationKey key = key_of(judge.operation(), configuration);
    const std::uint32_t other = class_of_key.try_emplace(key, number).first->second;
    if (!key_of_class[number]) key_of_class[number] = key;
    if (other != number || *key_of_class[number] != key)
      check.wrong.add(fmt::format("    {}\n  its key {:x} {:x} does not tell which worlds it fits\n",
                                  drawn(judge.operation().before, configuration), key.ports, key.joined.bits));
  }
  check.keys = class_of_key.size();
  return check;
}

OrbitSizes count_orbits(const RuleJudge& judge, const PatchSymmetries& symmetries) {
  const std::vector<std::uint32_t>& classes = judge.before().class_of_coloring;
  const unsigned ports = judge.before().ports;
  MergedSets sets(classes.size());
  for (const SideSymmetry& symmetry : symmetries.generators()) {
    const std::vector<Mask> ports_image = images_of_masks(symmetry.ports);
    const std::vector<Mask> edges_image = images_of_masks(symmetry.edges);
    for (Mask both = 0; both < classes.size(); ++both)
      sets.merge(both, concatenated(edges_image[high_part(both, ports)], ports_image[low_part(both, ports)], ports));
  }
  OrbitSizes orbits;
  for (Mask both = 0; both < classes.size(); ++both)
    if (sets.smallest(both) == both) {
      ++orbits.all;
      orbits.valid += classes[both] != FitClasses::not_valid ? 1U : 0U;
    }
  return orbits;
}

Failures wrong_copies(const OperationCertificate& certificate, const PatchSymmetries& symmetries) {
  Failures failures;
  const std::vector<OperationKey> smallest = smallest_keys(certificate, symmetries);
  for (std::size_t i = 0; i < certificate.rows.size(); ++i) {
    const RuleRow& row = certificate.rows[i];
    std::string fault;
    const bool smallest_is_rule =
        mutated(OperationMutant::accept_any_representative) || row.copy != (smallest[i] == row.key);
    if (!smallest_is_rule && row.copy)
      fault = "wrong representative: the smallest key of its orbit must be a rule, not a copy";
    else if (!smallest_is_rule)
      fault = fmt::format("wrong representative: {:x} {:x} is a smaller key of this orbit, so the row must be a copy",
                          smallest[i].ports, smallest[i].joined.bits);
    else if (row.copy)
      fault = fault_of_copy_row(row, certificate, symmetries);
    if (!fault.empty()) failures.add(fmt::format("{}  {}\n", at_row(certificate, row), fault));
  }
  return failures;
}

Failures wrong_numbers(const OperationCertificate& certificate, const RowCheck& rows, std::uint64_t keys,
                       const OrbitSizes& orbits) {
  const auto number = [](std::uint64_t count) { return static_cast<std::int64_t>(count); };
  const std::array<std::int64_t, number_words.size()> counted = {
      number(rows.configurations), number(rows.valid), number(orbits.all), number(orbits.valid), number(keys),
      number(rows.costing),        rows.worst_strips,  rows.worst_isolated};
  Failures failures;
  const std::size_t compared = number_words.size() - (mutated(OperationMutant::skip_last_number) ? 1 : 0);
  for (std::size_t i = 0; i < compared; ++i)
    if (certificate.claims[i].number != counted[i])
      failures.add(fmt::format("{}:{}: \"claim {} {}\"\n  wrong claim: recounted {}\n", certificate.file,
                               certificate.claims[i].line, number_words[i], certificate.claims[i].number, counted[i]));
  return failures;
}

}  // namespace restrip::verify::operations
