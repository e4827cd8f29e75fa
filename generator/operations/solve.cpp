#include "operations/solve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <map>
#include <optional>
#include <stdexcept>
#include <tuple>

#include "progress.hpp"

namespace restrip::generator {
namespace {

Mask image_of(const Term& term, const PatchMap& map) {
  switch (term.count) {
    case Count::kept:
      return permute(term.of, map.port);
    case Count::solid:
      return permute(term.of, map.after);
    case Count::ends:
    case Count::ends_at_port:
      return permute(term.of, map.nodes);
    default:
      return term.of;
  }
}

using TermInWords = std::tuple<Count, std::int64_t, Mask>;

std::vector<TermInWords> sorted(const Criterion& criterion, const PatchMap* map) {
  std::vector<TermInWords> terms;
  for (const Term& term : criterion)
    terms.emplace_back(term.count, term.weight, map != nullptr ? image_of(term, *map) : term.of);
  std::sort(terms.begin(), terms.end());
  return terms;
}

bool keeps(const PatchMap& map, const Operation& operation) {
  if (permute(operation.may_give_up, map.port) != operation.may_give_up) return false;
  return std::all_of(operation.preference.begin(), operation.preference.end(),
                     [&](const Criterion& criterion) { return sorted(criterion, &map) == sorted(criterion, nullptr); });
}

/// Pairs of ports as one mask, of at most eight ports.
Mask pairs_mask(const std::vector<Mask>& pairs) { return static_cast<Mask>(port_pairs(pairs).words[0]); }

OperationKey image_of(const OperationKey& key, const PatchMap& map) {
  std::vector<Mask> pairs = pairs_of(key.joined);
  for (Mask& pair : pairs) pair = permute(pair, map.port);
  return {permute(key.ports, map.port), pairs_mask(pairs)};
}

template <class Visit>
void for_each_valid_configuration(const Operation& operation, Visit&& visit) {
  const Side& before = operation.patch.before;
  for (const Coloring& coloring : legal_colorings(before, operation.constraint))
    for (Mask ports = 0; ports < Mask{1} << before.owner.size(); ++ports)
      if (const auto outcome = with_ports(coloring, ports))
        visit(coloring.inner, OperationKey{ports, pairs_mask(outcome->pairs)}, *outcome);
}

/// Names the first configuration that has the key.
[[noreturn]] void refuse_without_rule(const Operation& operation, const OperationKey& key) {
  std::optional<Mask> first;
  for_each_valid_configuration(operation, [&](Mask before, const OperationKey& own, const Outcome&) {
    if (own == key && !first) first = before;
  });
  std::string joined;
  for (const Mask pair : pairs_of(key.joined))
    joined += fmt::format("{} {} and {}", joined.empty() ? ", which joins the ports" : ",", std::countr_zero(pair),
                          std::bit_width(pair) - 1);
  throw std::runtime_error(
      fmt::format("the configuration {:x} {:x} (inner edges and ports that are solid before, as in a dump{}) has no "
                  "sound recolouring that keeps the ports that must stay; list more of its ports under \"give_up\"",
                  first.value_or(0), key.ports, joined));
}

std::vector<OperationRow> rows_of(const Operation& operation, const std::vector<PatchMap>& symmetry) {
  std::map<OperationKey, OperationRow> rows;
  for_each_valid_configuration(operation, [&](Mask, const OperationKey& key, const Outcome&) { rows[key].key = key; });
  const std::vector<Coloring> colorings = legal_colorings(operation.patch.after, operation.constraint);
  std::optional<Candidates> candidates;
  std::optional<Mask> candidates_of;
  Progress progress("found", rows.size(), "rules");
  for (auto& [key, row] : rows) {
    progress.step();
    // The representative is the orbit's smallest key, so it has been answered when a copy comes up.
    OperationKey representative = key;
    for (std::size_t s = 0; s < symmetry.size(); ++s) {
      const OperationKey image = image_of(key, symmetry[s]);
      if (image < representative) {
        representative = image;
        row.witness = static_cast<int>(s);
      }
    }
    if (row.witness < 0) {
      if (candidates_of != key.ports) candidates.emplace(operation, colorings, key.ports);
      candidates_of = key.ports;
      const Choice* const best = candidates->best(port_pairs(pairs_of(key.joined)));
      if (best == nullptr) refuse_without_rule(operation, key);
      row.choice = *best;
      continue;
    }
    const PatchMap& map = symmetry[static_cast<std::size_t>(row.witness)];
    row.choice = rows.at(representative).choice;
    row.choice.recoloring = permute(row.choice.recoloring, inverse(map.after));
    row.choice.kept = permute(row.choice.kept, inverse(map.port));
  }
  std::vector<OperationRow> list;
  list.reserve(rows.size());
  for (const auto& [key, row] : rows) list.push_back(row);
  return list;
}

const OperationRow& row_of(const std::vector<OperationRow>& rows, const OperationKey& key) {
  return *std::lower_bound(rows.begin(), rows.end(), key,
                           [](const OperationRow& row, const OperationKey& wanted) { return row.key < wanted; });
}

/// Counts what the rows amount to, and writes the table.
void answer_configurations(const Operation& operation, OperationRules& rules) {
  const Patch& patch = operation.patch;
  const auto ports = static_cast<unsigned>(patch.before.owner.size());
  const bool matching = operation.constraint.most_edges == 1;
  Claims& claims = rules.claims;
  claims.configurations = std::size_t{1} << (patch.before.edges.size() + ports);
  rules.entries.assign(matching ? std::size_t{1} << ports : claims.configurations, -1);
  const Smallest smallest(patch, rules.symmetry);
  claims.orbits = smallest.orbits();
  for_each_valid_configuration(operation, [&](Mask before, const OperationKey& key, const Outcome& outcome) {
    const Choice& choice = row_of(rules.rows, key).choice;
    const int strips_before = static_cast<int>(patch.before.nodes - outcome.solid) - std::popcount(key.ports);
    const int strips = static_cast<int>(patch.after.nodes - choice.solid) - std::popcount(choice.kept) - strips_before;
    const int isolated = static_cast<int>(choice.isolated) - static_cast<int>(outcome.isolated);
    claims.count(strips, isolated, (matching ? isolated : strips) >= 1, smallest(before, key.ports));
    rules.entries[matching ? key.ports : std::size_t{before} << ports | key.ports] =
        static_cast<std::int32_t>(choice.recoloring << ports | choice.kept);
  });
}

}  // namespace

std::vector<Mask> pairs_of(Mask joined) {
  std::vector<Mask> pairs;
  for (unsigned high = 1; high < most_ports; ++high)
    for (unsigned low = 0; low < high; ++low)
      if ((joined >> (high * (high - 1) / 2 + low) & 1U) != 0) pairs.push_back(Mask{1} << high | Mask{1} << low);
  return pairs;
}

std::vector<PatchMap> symmetries_of(const Operation& operation) {
  std::vector<PatchMap> maps = automorphisms(operation.patch);
  std::erase_if(maps, [&](const PatchMap& map) { return !keeps(map, operation); });
  return maps;
}

OperationRules solve(const NamedOperation& named) {
  OperationRules rules;
  rules.symmetry = symmetries_of(named.operation);
  try {
    rules.rows = rows_of(named.operation, rules.symmetry);
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(fmt::format("operation {}: {}", named.name, error.what()));
  }
  answer_configurations(named.operation, rules);
  return rules;
}

}  // namespace restrip::generator
