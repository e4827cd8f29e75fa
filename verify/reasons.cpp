#include "reasons.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "mutants.hpp"

namespace restrip::verify {
namespace {

/// What a recolouring gives away, in the order of preference; less is better.
struct Loss {
  int dashed = 0;    ///< edges
  int isolated = 0;  ///< triangles, every port given up counting as one
  int given_up = 0;  ///< ports
  friend constexpr auto operator<=>(const Loss&, const Loss&) = default;
};

/// Sets of edges are masks: inner edges first; then the ports, for a flip, which may give them up.
class ReasonChecker {
 public:
  ReasonChecker(const Row& row, const Section& section) : patch_(section.operations.front().after) {
    const Operation& operation = section.operations.front();
    const Mask inner = mask_count(patch_.inner_edges()) - 1;
    if (operation.gives_ports_up) {
      edges_ = concatenated(row.key.ports, inner, patch_.inner_edges());
      joined_before_ = survey(operation.before, {row.key.second, row.key.ports}).joined;
      row_loss_ = loss(edges_ & ~concatenated(row.after.ports, row.after.inner, patch_.inner_edges()));
    } else {
      edges_ = inner;
      kept_ports_ = row.key.ports;
      joined_before_ = pairs_of(row.key.second, row.key.ports, section.ports, patch_.closed()).value_or(PortPairs{});
      row_loss_ = loss(edges_ & ~row.after.inner);
    }
  }

  /// What is wrong with a reason, where the edges `solid` are solid and the edges `dashed` are not; or nothing.
  std::string fault(const Reason& reason, Mask solid, Mask dashed) const {
    if (reason.cases.empty()) return fault_of_leaf(reason.sets, solid, dashed);
    const Mask edge = single(reason.edge);
    if (!is_subset(edge, edges_) && !mutated(Mutant::reason_foreign_edges))
      return fmt::format("edge {} is dashed before", reason.edge);
    std::string first = fault(reason.cases[0], solid | edge, dashed);
    if (mutated(Mutant::reason_skip_solid_case)) first.clear();
    if (!first.empty() || mutated(Mutant::reason_skip_dashed_case)) return first;
    return fault(reason.cases[1], mutated(Mutant::reason_solid_in_both_cases) ? solid | edge : solid, dashed | edge);
  }

 private:
  std::string fault_of_leaf(const std::vector<Mask>& sets, Mask solid, Mask dashed) const {
    Mask taken = mutated(Mutant::reason_count_dashed_twice) ? solid : solid | dashed;
    Mask surely_dashed = dashed;
    for (const Mask set : sets) {
      if (!is_subset(set, edges_) && !mutated(Mutant::reason_foreign_edges))
        return fmt::format("the set {:x} has a port that is dashed before", set);
      if ((set & taken) != 0 && !mutated(Mutant::reason_overlapping_sets))
        return fmt::format("the set {:x} has an edge that another set has or a case settles", set);
      if (is_sound(set | solid) && !mutated(Mutant::reason_sound_sets))
        return fmt::format("the set {:x} may be all solid", set);
      taken |= set;
      if (solid_count(set) == 1) surely_dashed |= set;
    }
    Loss least = loss(surely_dashed);
    least.dashed = static_cast<int>(solid_count(dashed) + sets.size());
    if (mutated(Mutant::reason_off_by_one)) ++least.dashed;
    if (mutated(Mutant::reason_only_dashed)) least.isolated = least.given_up = static_cast<int>(solid_count(edges_));
    if (least >= row_loss_) return {};
    return fmt::format("a case shows {} dashed, {} isolated, {} ports given up; the row has {}, {}, {}", least.dashed,
                       least.isolated, least.given_up, row_loss_.dashed, row_loss_.isolated, row_loss_.given_up);
  }

  Coloring coloring(Mask edges) const {
    return {low_part(edges, patch_.inner_edges()), kept_ports_ | high_part(edges, patch_.inner_edges())};
  }

  bool is_sound(Mask solid_edges) const {
    const Survey found = survey(patch_, coloring(solid_edges));
    return found.valid && found.joined.within(joined_before_);
  }

  /// Of a recolouring that leaves these edges dashed and no other.
  Loss loss(Mask dashed) const {
    const Coloring colors = coloring(edges_ & ~dashed);
    Loss result{static_cast<int>(solid_count(dashed)), 0,
                static_cast<int>(solid_count(high_part(dashed, patch_.inner_edges())))};
    result.isolated = result.given_up;
    for (const Node triangle : patch_.triangles()) {
      bool alone = true;
      for (auto [edge, end] = boost::out_edges(triangle, patch_.graph()); edge != end; ++edge)
        alone = alone && !solid(patch_.graph()[*edge], colors);
      result.isolated += alone ? 1 : 0;
    }
    return result;
  }

  const Patch& patch_;
  Mask edges_ = 0;       ///< those that a recolouring may leave dashed
  Mask kept_ports_ = 0;  ///< those that it may not
  PortPairs joined_before_;
  Loss row_loss_;
};

}  // namespace

std::string fault_of_reason(const Row& row, const Section& section) {
  if (mutated(Mutant::reason_any)) return {};
  return ReasonChecker(row, section).fault(row.reason, 0, 0);
}

void check_reasons(const Section& section, const SectionRows& rows, const std::string& file, ReasonTally& tally) {
  for (const Row& row : rows.rows) {
    if (row.copy) continue;
    ++tally.rules;
    const std::size_t cases = cases_of(row.reason);
    tally.trees += cases > 1 ? 1U : 0U;
    tally.most_cases = std::max(tally.most_cases, cases);
    if (const std::string fault = fault_of_reason(row, section); !fault.empty())
      tally.wrong.add(fmt::format("{}:{}: \"{}\"\n  section {}: wrong reason: {}", file, row.line,
                                  text_of(row, section.operations.front().gives_ports_up), section.position, fault));
  }
}

}  // namespace restrip::verify
