#include "section_check.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "mutants.hpp"

namespace restrip::verify {
namespace {

const Row* row_with(const SectionRows& rows, Key key) {
  const auto place =
      std::lower_bound(rows.rows.begin(), rows.rows.end(), key, [](const Row& row, Key k) { return row.key < k; });
  return place != rows.rows.end() && place->key == key ? &*place : nullptr;
}

/// True when the symmetry can take one row's recolouring to the other's.
bool carries(const Row& row, const Row& representative, PortSymmetry by, const Section& section) {
  const Mask ports = permuted(row.after.ports, port_permutation(by, section.ports));
  if (ports != representative.after.ports) return false;
  const std::vector<EdgePermutation> ways = extensions(section.operations.front().after, by);
  return std::any_of(ways.begin(), ways.end(), [&](const EdgePermutation& edges) {
    return permuted(row.after.inner, edges) == representative.after.inner;
  });
}

std::string fault_of_copy(const Row& row, const SectionRows& rows, const Section& section,
                          const std::vector<PortSymmetry>& allowed) {
  const bool is_allowed = std::any_of(allowed.begin(), allowed.end(), [&](PortSymmetry symmetry) {
    return port_permutation(symmetry, section.ports) == port_permutation(row.by, section.ports);
  });
  if (!is_allowed) return fmt::format("wrong witness: {} does not keep the position", row.by.text());
  const Key image = image_of(row.key, row.by, section);
  const Row* representative = row_with(rows, image);
  if (representative == nullptr || representative->copy)
    return fmt::format("wrong witness: {} takes the key to {:x} {:x}, which has no rule row", row.by.text(),
                       image.ports, image.second);
  if (!carries(row, *representative, row.by, section))
    return fmt::format("wrong witness: {} does not take the recolouring to that of line {}", row.by.text(),
                       representative->line);
  return {};
}

}  // namespace

Failures extra_rows(const Section& section, const SectionRows& rows, const std::vector<bool>& used,
                    const std::string& file) {
  Failures failures;
  if (mutated(Mutant::accept_extra)) return failures;
  for (std::size_t i = 0; i < rows.rows.size(); ++i)
    if (!used[i])
      failures.add(fmt::format("{}:{}: \"{}\"\n  extra row: no valid configuration of section {} has this key", file,
                               rows.rows[i].line, text_of(rows.rows[i], section.operations.front().gives_ports_up),
                               section.position));
  return failures;
}

Failures wrong_witnesses(const Section& section, const SectionRows& rows, const std::string& file) {
  Failures failures;
  const std::vector<PortSymmetry> allowed = symmetries_of(section);
  for (const Row& row : rows.rows) {
    Key smallest = row.key;
    for (const PortSymmetry symmetry : allowed) smallest = std::min(smallest, image_of(row.key, symmetry, section));
    std::string fault;
    if (!mutated(Mutant::skip_representative) && row.copy == (smallest == row.key))
      fault = row.copy ? "wrong representative: the smallest key of its orbit must be a rule, not a copy"
                       : fmt::format(
                             "wrong representative: {:x} {:x} is a smaller key of this orbit, so the row must "
                             "be a copy",
                             smallest.ports, smallest.second);
    else if (row.copy && !mutated(Mutant::skip_witness))
      fault = fault_of_copy(row, rows, section, allowed);
    if (!fault.empty())
      failures.add(fmt::format("{}:{}: \"{}\"\n  section {}: {}", file, row.line,
                               text_of(row, section.operations.front().gives_ports_up), section.position, fault));
  }
  return failures;
}

void Recount::add(const Judgment& judgment, const OrbitCounts& orbits) {
  const bool first = numbers[0] == 0;
  const auto worst = [&](std::int64_t& number, std::optional<int> found) {
    if (found) number = first ? *found : std::max<std::int64_t>(number, *found);
  };
  worst(numbers[5], judgment.worst_strips);
  worst(numbers[6], judgment.worst_isolated);
  const std::array<std::uint64_t, 5> sums = {judgment.configurations, judgment.valid, orbits.all, orbits.valid,
                                             judgment.costing};
  for (std::size_t i = 0; i < sums.size(); ++i) numbers[i] += static_cast<std::int64_t>(sums[i]);
}

Failures wrong_claims(const SectionRows& rows, const Recount& recount, const std::string& file) {
  Failures failures;
  if (mutated(Mutant::skip_claims)) return failures;
  for (std::size_t i = 0; i < claim_words.size(); ++i)
    if (rows.claims[i].number != recount.numbers[i])
      failures.add(fmt::format("{}:{}: \"claim {} {}\"\n  wrong claim: recounted {}", file, rows.claims[i].line,
                               claim_words[i], rows.claims[i].number, recount.numbers[i]));
  return failures;
}

}  // namespace restrip::verify
