#include "reason.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <tuple>

namespace restrip::generator {
namespace {

EdgeSet single(std::size_t edge) { return EdgeSet{1} << edge; }

bool smaller(EdgeSet x, EdgeSet y) { return std::tuple{std::popcount(x), x} < std::tuple{std::popcount(y), y}; }

/// Every simple path of inner edges from `at` to `goal` that avoids the nodes `used` and the edges `avoided`.
void collect_paths(const Side& side, unsigned at, unsigned goal, EdgeSet avoided, Mask used, EdgeSet path,
                   std::vector<EdgeSet>& found) {
  if (at == goal) {
    found.push_back(path);
    return;
  }
  used |= Mask{1} << at;
  for (std::size_t e = 0; e < side.edges.size(); ++e) {
    const auto [u, v] = side.edges[e];
    if ((avoided & single(e)) != 0 || (u != at && v != at)) continue;
    const unsigned next = u == at ? v : u;
    if ((used >> next & 1U) == 0) collect_paths(side, next, goal, avoided, used, path | single(e), found);
  }
}

/// Sets that contain no other, in ascending order of (size, set), each once.
std::vector<EdgeSet> smallest(std::vector<EdgeSet> sets) {
  std::sort(sets.begin(), sets.end(), smaller);
  std::vector<EdgeSet> kept;
  for (const EdgeSet set : sets)
    if (std::none_of(kept.begin(), kept.end(), [&](EdgeSet other) { return (other & ~set) == 0; })) kept.push_back(set);
  return kept;
}

/// The first `count` disjoint sets in the order of the list.
bool choose_disjoint(const std::vector<EdgeSet>& sets, std::size_t from, int count, EdgeSet taken,
                     std::vector<EdgeSet>& chosen) {
  if (count <= 0) return true;
  for (std::size_t i = from; i < sets.size(); ++i) {
    if ((sets[i] & taken) != 0) continue;
    chosen.push_back(sets[i]);
    if (choose_disjoint(sets, i + 1, count - 1, taken | sets[i], chosen)) return true;
    chosen.pop_back();
  }
  return false;
}

}  // namespace

std::size_t Reason::leaves() const { return cases.empty() ? 1 : cases[0].leaves() + cases[1].leaves(); }

std::string Reason::text() const {
  if (!cases.empty()) return fmt::format("if {} then {} else {}", edge, cases[0].text(), cases[1].text());
  std::string words;
  for (const EdgeSet set : sets) words += fmt::format("{}{:x}", words.empty() ? "" : " ", set);
  return words.empty() ? "-" : words;
}

bool has_reasons(const Operation& operation) {
  const Preference first = fewest_strips();
  return operation.constraint.most_edges >= 2 && operation.preference.size() >= first.size() &&
         std::equal(first.begin(), first.end(), operation.preference.begin());
}

Reasoner::Reasoner(const Operation& operation) : may_give_up_(operation.may_give_up), after_(operation.patch.after) {
  const std::size_t inner = after_.edges.size();
  const auto port = [&](std::size_t p) { return single(inner + p); };
  for (unsigned node = 0; node < after_.nodes; ++node) {
    EdgeSet edges = 0;
    for (std::size_t e = 0; e < inner; ++e)
      if (after_.edges[e].u == node || after_.edges[e].v == node) edges |= single(e);
    for (std::size_t p = 0; p < after_.owner.size(); ++p)
      if (after_.owner[p] == node) edges |= port(p);
    if (std::popcount(edges) > static_cast<int>(operation.constraint.most_edges)) forbidden_.push_back({edges, 0});
  }
  std::vector<EdgeSet> paths;
  for (std::size_t e = 0; e < inner; ++e) {
    paths.clear();
    collect_paths(after_, after_.edges[e].u, after_.edges[e].v, single(e), 0, single(e), paths);
    for (const EdgeSet cycle : paths) forbidden_.push_back({cycle, 0});
  }
  for (std::size_t p = 0; p < after_.owner.size(); ++p)
    for (std::size_t q = p + 1; q < after_.owner.size(); ++q) {
      paths.clear();
      collect_paths(after_, after_.owner[p], after_.owner[q], 0, 0, port(p) | port(q), paths);
      for (const EdgeSet path : paths) forbidden_.push_back({path, Mask{1} << p | Mask{1} << q});
    }
}

Reasoner::Goal Reasoner::goal_of(Mask solid_ports, const std::vector<Mask>& joined, const Choice& best) const {
  const std::size_t inner = after_.edges.size();
  const EdgeSet ports = solid_ports << inner;
  const EdgeSet everything = (single(inner) - 1) | ports;
  Goal goal;
  const EdgeSet staying = (solid_ports & ~may_give_up_) << inner;
  goal.edges = everything & ~staying;
  for (const Forbidden& set : forbidden_)
    if ((set.edges & ~everything) == 0 && std::find(joined.begin(), joined.end(), set.pair) == joined.end())
      goal.sets.push_back(set.edges & goal.edges);
  for (unsigned node = 0; node < after_.nodes; ++node) {
    EdgeSet edges = 0;
    for (std::size_t e = 0; e < inner; ++e)
      if (after_.edges[e].u == node || after_.edges[e].v == node) edges |= single(e);
    for (std::size_t p = 0; p < after_.owner.size(); ++p)
      if (after_.owner[p] == node) edges |= single(inner + p) & ports;
    // A triangle with a solid port that stays is never isolated.
    if ((edges & ~goal.edges) == 0) goal.triangles.push_back(edges);
  }
  const EdgeSet recoloring = best.recoloring | best.kept << inner;
  goal.dashed = std::popcount(goal.edges & ~recoloring);
  goal.isolated = static_cast<int>(best.isolated);
  goal.given_up = std::popcount(solid_ports & ~best.kept);
  return goal;
}

bool Reasoner::find_leaf(const Goal& goal, EdgeSet solid, EdgeSet dashed, Reason& reason) const {
  std::vector<EdgeSet> sets;
  for (const EdgeSet set : goal.sets)
    if ((set & dashed) == 0) sets.push_back(set & ~solid);
  sets = smallest(sets);
  // With an edge that must be dashed, the case that it is solid would be empty: no smallest tree has such a case.
  if (!sets.empty() && sets.front() == 0) return false;
  const int missing = goal.dashed - std::popcount(dashed);
  const bool only_dashed_counts = goal.isolated == 0 && goal.given_up == 0;
  for (const int count : {missing, missing + 1}) {
    reason = {};
    if (!choose_disjoint(sets, 0, count, 0, reason.sets)) return false;
    EdgeSet surely_dashed = dashed;
    for (const EdgeSet set : reason.sets)
      if (std::has_single_bit(set)) surely_dashed |= set;
    const int given_up = std::popcount(surely_dashed >> after_.edges.size());
    const auto isolated = std::count_if(goal.triangles.begin(), goal.triangles.end(),
                                        [&](EdgeSet edges) { return (edges & ~surely_dashed) == 0; });
    if (only_dashed_counts || count > missing ||
        std::tuple{static_cast<int>(isolated) + given_up, given_up} >= std::tuple{goal.isolated, goal.given_up})
      return true;
  }
  return false;
}

bool Reasoner::find(const Goal& goal, EdgeSet solid, EdgeSet dashed, std::size_t leaves, Reason& reason) const {
  if (find_leaf(goal, solid, dashed, reason)) return true;
  for (unsigned edge = 0; leaves > 1 && edge < 32; ++edge) {
    if ((goal.edges & ~solid & ~dashed & single(edge)) == 0) continue;
    Reason tree{edge, {{}, {}}, {}};
    for (std::size_t first = 1; first < leaves; ++first) {
      if (!find(goal, solid | single(edge), dashed, first, tree.cases[0])) continue;
      if (!find(goal, solid, dashed | single(edge), leaves - first, tree.cases[1])) break;
      reason = tree;
      return true;
    }
  }
  return false;
}

Reason Reasoner::reason(Mask ports, const std::vector<Mask>& joined, const Choice& best) const {
  const Goal goal = goal_of(ports, joined, best);
  Reason reason;
  for (std::size_t leaves = 1; !find(goal, 0, 0, leaves, reason); ++leaves) continue;
  return reason;
}

}  // namespace restrip::generator
