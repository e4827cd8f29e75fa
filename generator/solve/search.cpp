#include "solve/search.hpp"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <stdexcept>
#include <tuple>
#include <vector>

namespace restrip::generator {

namespace {

/// The values of the criteria for a colouring after the operation whose ports `kept`, out of `ports`, are solid.
/// Depends on the patch alone, never on the machine.
CriterionValues values_of(const Operation& operation, const Coloring& coloring, const Outcome& outcome, Mask ports,
                          Mask kept) {
  const Side& after = operation.patch.after;
  std::vector<int> inner_degree(after.nodes, 0);
  for (std::size_t e = 0; e < after.edges.size(); ++e) {
    if ((coloring.inner >> e & 1U) == 0) continue;
    ++inner_degree[after.edges[e].u];
    ++inner_degree[after.edges[e].v];
  }
  std::vector<int> degree = inner_degree;
  for (std::size_t p = 0; p < after.owner.size(); ++p) degree[after.owner[p]] += (kept >> p & 1U) != 0 ? 1 : 0;
  const auto end = [&](unsigned node) { return degree[node] == 1; };
  const auto nodes_where = [&](Mask of, const auto& holds) {
    int count = 0;
    for (unsigned node = 0; node < after.nodes; ++node) count += (of >> node & 1U) != 0 && holds(node) ? 1 : 0;
    return count;
  };
  const auto counted = [&](const Term& term) -> int {
    switch (term.count) {
      case Count::strips:
        return static_cast<int>(after.nodes - outcome.solid) - std::popcount(kept);
      case Count::isolated:
        return static_cast<int>(outcome.isolated);
      case Count::given_up:
        return std::popcount(ports & ~kept);
      case Count::kept:
        return std::popcount(kept & term.of);
      case Count::joined:
        return static_cast<int>(outcome.joined.size());
      case Count::solid:
        return std::popcount(coloring.inner & term.of);
      case Count::ends:
        return nodes_where(term.of, end);
      case Count::ends_at_port:
        return nodes_where(term.of, [&](unsigned node) { return end(node) && inner_degree[node] == 0; });
      case Count::neighbouring_ends: {
        int count = 0;
        for (const auto& [u, v] : after.edges) count += end(u) && end(v) ? 1 : 0;
        return count;
      }
      case Count::squares: {
        int sum = 0;
        for (const Mask strip : coloring.strips) sum += std::popcount(strip) * std::popcount(strip);
        return sum;
      }
    }
    throw std::logic_error("a count without a meaning");
  };
  CriterionValues values{};
  for (std::size_t i = 0; i < operation.preference.size(); ++i)
    for (const Term& term : operation.preference[i]) values[i] += term.weight * counted(term);
  for (const Term& term : operation.tie_break) values.back() += term.weight * counted(term);
  return values;
}

/// Calls visit for every valid recolouring with its colouring, kept ports and outcome.
template <class Visit>
void for_each_recoloring(const Operation& operation, const std::vector<Coloring>& colorings, Mask ports,
                         Visit&& visit) {
  const Mask may_give_up = ports & operation.may_give_up;
  for (const Coloring& coloring : colorings)
    for (Mask given_up = may_give_up;; given_up = (given_up - 1) & may_give_up) {
      const Mask kept = ports & ~given_up;
      if (const auto outcome = with_ports(coloring, kept)) visit(coloring, kept, *outcome);
      if (given_up == 0) break;
    }
}

}  // namespace

std::vector<PortPairs> relevant_pairs(const Operation& operation) {
  const std::vector<Coloring> colorings = legal_colorings(operation.patch.after, operation.constraint);
  std::vector<PortPairs> joined;
  for (Mask ports = 0; ports <= operation.patch.after.all_ports(); ++ports) {
    joined.emplace_back();
    for_each_recoloring(operation, colorings, ports,
                        [&](const Coloring&, Mask, const Outcome& outcome) { joined.back() |= outcome.joined; });
  }
  return joined;
}

std::vector<Candidate> candidates_for(const Operation& operation, const std::vector<Coloring>& colorings, Mask ports) {
  std::vector<Candidate> candidates;
  for_each_recoloring(operation, colorings, ports, [&](const Coloring& coloring, Mask kept, const Outcome& outcome) {
    const auto lost = static_cast<unsigned>(std::popcount(ports & ~kept));
    candidates.push_back({{coloring.inner, kept, outcome.solid, outcome.isolated + lost},
                          outcome.joined,
                          values_of(operation, coloring, outcome, ports, kept)});
  });
  std::sort(candidates.begin(), candidates.end(), [](const Candidate& x, const Candidate& y) {
    return std::tie(x.values, x.recoloring, x.kept) < std::tie(y.values, y.recoloring, y.kept);
  });
  return candidates;
}

}  // namespace restrip::generator
