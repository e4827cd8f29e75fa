#include "search.hpp"

#include <algorithm>
#include <bit>
#include <tuple>

namespace restrip::generator {

void PortPairs::add(unsigned low, unsigned high) {
  const unsigned place = high * (high - 1) / 2 + low;
  words[place / 64] |= std::uint64_t{1} << place % 64;
}

PortPairs port_pairs(const std::vector<Mask>& pairs) {
  PortPairs set;
  for (const Mask pair : pairs)
    set.add(static_cast<unsigned>(std::countr_zero(pair)), static_cast<unsigned>(std::bit_width(pair)) - 1);
  return set;
}

Candidates::Candidates(const Operation& operation, const std::vector<Coloring>& colorings, Mask ports) {
  const Side& after = operation.patch.after;
  const Mask may_give_up = ports & operation.may_give_up;
  for (const Coloring& coloring : colorings) {
    for (Mask given_up = may_give_up;; given_up = (given_up - 1) & may_give_up) {
      const Mask kept = ports & ~given_up;
      if (const auto outcome = with_ports(coloring, kept)) {
        const auto lost = static_cast<unsigned>(std::popcount(given_up));
        candidates_.push_back({{coloring.inner, kept, outcome->solid, outcome->isolated + lost},
                               port_pairs(outcome->pairs),
                               values_of(operation.preference, after, coloring, *outcome, ports, kept)});
      }
      if (given_up == 0) break;
    }
  }
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

}  // namespace restrip::generator
