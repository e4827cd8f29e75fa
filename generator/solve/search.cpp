#include "solve/search.hpp"

#include <algorithm>
#include <bit>
#include <tuple>

namespace restrip::generator {

namespace {

/// Calls visit for every valid recolouring: its colouring, the ports that it keeps, and what comes of them.
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

Candidates::Candidates(const Operation& operation, const std::vector<Coloring>& colorings, Mask ports) {
  for_each_recoloring(operation, colorings, ports, [&](const Coloring& coloring, Mask kept, const Outcome& outcome) {
    const auto lost = static_cast<unsigned>(std::popcount(ports & ~kept));
    candidates_.push_back({{coloring.inner, kept, outcome.solid, outcome.isolated + lost},
                           outcome.joined,
                           values_of(operation, coloring, outcome, ports, kept)});
  });
  std::sort(candidates_.begin(), candidates_.end(), [](const Candidate& x, const Candidate& y) {
    return std::tie(x.values, x.choice.recoloring, x.choice.kept) <
           std::tie(y.values, y.choice.recoloring, y.choice.kept);
  });
}

const Choice* Candidates::best(const PortPairs& joined_before) const {
  for (const Candidate& candidate : candidates_)
    if (candidate.joins.within(joined_before)) return &candidate.choice;
  return nullptr;
}

std::vector<std::pair<Choice, PortPairs>> Candidates::uncovered() const {
  std::vector<std::pair<Choice, PortPairs>> list;
  for (const Candidate& candidate : candidates_) {
    const bool covered = std::any_of(list.begin(), list.end(),
                                     [&](const auto& earlier) { return earlier.second.within(candidate.joins); });
    if (!covered) list.emplace_back(candidate.choice, candidate.joins);
  }
  return list;
}

}  // namespace restrip::generator
