#include "solve/reason_search.hpp"

#include <algorithm>
#include <bit>
#include <tuple>

namespace restrip::generator {
namespace {

/// A leaf of a greedy tree is given up after so many steps, and its cases are told.
constexpr std::uint64_t most_steps_of_leaf = 2000;

bool smaller(EdgeSet x, EdgeSet y) { return std::tuple{std::popcount(x), x} < std::tuple{std::popcount(y), y}; }

}  // namespace

/// In ascending order of (size, set), each once.
std::vector<EdgeSet> ReasonSearch::open_sets(EdgeSet solid, EdgeSet dashed) {
  std::vector<EdgeSet> open;
  for (const EdgeSet set : goal_.sets)
    if ((set & dashed) == 0) open.push_back(set & ~solid);
  std::sort(open.begin(), open.end(), smaller);
  std::vector<EdgeSet> kept;
  for (const EdgeSet set : open)
    if (std::none_of(kept.begin(), kept.end(), [&](EdgeSet other) { return (other & ~set) == 0; })) kept.push_back(set);
  steps_ += goal_.sets.size();
  return kept;
}

/// The first `count` disjoint sets in the order of the list.
bool ReasonSearch::choose_disjoint(const std::vector<EdgeSet>& sets, std::size_t from, int count, EdgeSet taken,
                                   std::vector<EdgeSet>& chosen) {
  if (count <= 0) return true;
  for (std::size_t i = from; i < sets.size() && steps_ <= last_step_; ++i) {
    ++steps_;
    if ((sets[i] & taken) != 0) continue;
    chosen.push_back(sets[i]);
    if (choose_disjoint(sets, i + 1, count - 1, taken | sets[i], chosen)) return true;
    chosen.pop_back();
  }
  return false;
}

std::optional<Reason> ReasonSearch::leaf(const std::vector<EdgeSet>& sets, EdgeSet dashed) {
  // With an edge that must be dashed, the case that it is solid would be empty: no smallest tree has such a case.
  if (!sets.empty() && sets.front() == 0) return {};
  const int missing = goal_.dashed - std::popcount(dashed);
  const bool only_dashed_counts = goal_.isolated == 0 && goal_.given_up == 0;
  for (const int count : {missing, missing + 1}) {
    Reason reason;
    if (!choose_disjoint(sets, 0, count, 0, reason.sets)) return {};
    EdgeSet surely_dashed = dashed;
    for (const EdgeSet set : reason.sets)
      if (std::has_single_bit(set)) surely_dashed |= set;
    const int given_up = std::popcount(surely_dashed >> goal_.inner_edges);
    const auto isolated = std::count_if(goal_.triangles.begin(), goal_.triangles.end(),
                                        [&](EdgeSet edges) { return (edges & ~surely_dashed) == 0; });
    if (only_dashed_counts || count > missing ||
        std::tuple{static_cast<int>(isolated) + given_up, given_up} >= std::tuple{goal_.isolated, goal_.given_up})
      return reason;
  }
  return {};
}

// It is asked for trees of one leaf first, then two, and of each case for as few as that leaves. So it is never asked
// for more leaves than the smallest tree has, and what it answers depends on the state alone: it can be kept.
const Reason* ReasonSearch::find(EdgeSet solid, EdgeSet dashed, std::size_t leaves) {
  if (++steps_ > last_step_) return nullptr;
  Known& known = known_[std::uint64_t{solid} << 32U | dashed];  // stays where it is while others are added
  if (known.reason) return known.reason->leaves() <= leaves ? &*known.reason : nullptr;
  if (known.too_few == 0) known.reason = leaf(open_sets(solid, dashed), dashed);
  if (known.reason) return &*known.reason;
  if (known.too_few >= leaves) return nullptr;
  for (unsigned edge = 0; leaves > 1 && edge < 32; ++edge) {
    if ((goal_.edges & ~solid & ~dashed & single(edge)) == 0) continue;
    for (std::size_t first = 1; first < leaves; ++first) {
      const Reason* const when_solid = find(solid | single(edge), dashed, first);
      if (when_solid == nullptr) continue;
      const Reason* const when_dashed = find(solid, dashed | single(edge), leaves - first);
      if (when_dashed == nullptr) break;
      known.reason = Reason{edge, {*when_solid, *when_dashed}, {}};
      return &*known.reason;
    }
  }
  if (steps_ <= last_step_) known.too_few = leaves;
  return nullptr;
}

std::optional<Reason> ReasonSearch::smallest(std::uint64_t most_steps) {
  known_.clear();
  last_step_ = steps_ + most_steps;
  for (std::size_t leaves = 1; steps_ <= last_step_; ++leaves)
    if (const Reason* const found = find(0, 0, leaves)) return *found;
  return {};
}

Reason ReasonSearch::greedy() { return greedy(0, 0); }

Reason ReasonSearch::greedy(EdgeSet solid, EdgeSet dashed) {
  const std::vector<EdgeSet> sets = open_sets(solid, dashed);
  last_step_ = steps_ + most_steps_of_leaf;
  if (std::optional<Reason> found = leaf(sets, dashed)) return *std::move(found);
  // An edge in a set of its own is dashed in any case. If there is no other, the sets are all of one edge, and the leaf
  // was found above at once.
  unsigned best = 0;
  std::uint64_t most = 0;
  for (unsigned edge = 0; edge < 32; ++edge) {
    std::uint64_t weight = 0;
    for (const EdgeSet set : sets)
      if (!std::has_single_bit(set) && (set & single(edge)) != 0)
        weight += std::uint64_t{1} << (32 - std::popcount(set));
    if (weight > most) {
      most = weight;
      best = edge;
    }
  }
  return {best, {greedy(solid | single(best), dashed), greedy(solid, dashed | single(best))}, {}};
}

}  // namespace restrip::generator
