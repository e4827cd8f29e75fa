#include "search.hpp"

#include <algorithm>
#include <bit>
#include <stdexcept>
#include <tuple>

#include "preference.hpp"

namespace restrip::generator {
namespace {

/// Pairs among a flip's four ports, one bit for each of the 4 x 4 (low, high).
Mask flip_pairs(const std::vector<Mask>& pairs) {
  Mask mask = 0;
  for (const Mask pair : pairs) {
    const int low = std::countr_zero(pair);
    const int high = std::countr_zero(std::bit_floor(pair));
    mask |= Mask{1} << (4 * low + high);
  }
  return mask;
}

}  // namespace

Candidates::Candidates(const Position& position, const Side& after, const std::vector<Coloring>& colorings, Mask ports,
                       Goal goal)
    : position_(position), goal_(goal) {
  for (const Coloring& coloring : colorings) {
    if (position.family != Family::flip) {
      add(after, coloring, ports, ports);
      continue;
    }
    for (Mask kept = ports;; kept = (kept - 1) & ports) {
      add(after, coloring, ports, kept);
      if (kept == 0) break;
    }
  }
  std::sort(candidates_.begin(), candidates_.end(), [](const Candidate& x, const Candidate& y) {
    const auto rank = [](const Candidate& c) {
      const int ports_kept = std::popcount(c.row.kept);
      return std::tuple{-static_cast<int>(c.row.solid) - ports_kept,
                        c.row.isolated,
                        -ports_kept,
                        c.tie,
                        c.row.recoloring,
                        c.row.kept};
    };
    return rank(x) < rank(y);
  });
}

void Candidates::add(const Side& after, const Coloring& coloring, Mask ports, Mask kept) {
  const auto outcome = with_ports(after, coloring, kept);
  if (!outcome) return;
  const auto given_up = static_cast<unsigned>(std::popcount(ports & ~kept));
  Candidate candidate;
  candidate.row = {{}, coloring.inner, kept, outcome->solid, outcome->isolated + given_up, -1};
  candidate.tie = tie_break(position_, after, coloring, *outcome, kept, Sight::patch, goal_);
  if (position_.family == Family::flip) {
    candidate.joins = flip_pairs(outcome->pairs);
  } else {
    // A pair of ports that are not consecutive is in no key: such a recolouring is never sound.
    bool leftover = false;
    candidate.joins = joined_to_previous(outcome->pairs, kept, position_.k, closed(position_.family), &leftover);
    if (leftover) return;
  }
  candidates_.push_back(candidate);
}

Row Candidates::best(const Key& key) const {
  Mask allowed = key.joined;
  if (position_.family == Family::flip) {
    // The key is the configuration itself; its pairing follows from it.
    const Side before = make_patch(position_).before;
    for (const Coloring& coloring : legal_colorings(before))
      if (coloring.inner == key.joined) allowed = flip_pairs(with_ports(before, coloring, key.ports).value().pairs);
  }
  for (const Candidate& candidate : candidates_) {
    if ((candidate.joins & ~allowed) != 0) continue;
    Row row = candidate.row;
    row.key = key;
    return row;
  }
  throw std::logic_error("a key without a sound recolouring");
}

}  // namespace restrip::generator
