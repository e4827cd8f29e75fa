#include "solve/reason.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <optional>
#include <utility>

#include "solve/reason_search.hpp"

namespace restrip::generator {
namespace {

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

ReasonGoal Reasoner::goal_of(Mask solid_ports, const std::vector<Mask>& joined, const Choice& best) const {
  const std::size_t inner = after_.edges.size();
  const EdgeSet ports = solid_ports << inner;
  const EdgeSet everything = (single(inner) - 1) | ports;
  ReasonGoal goal;
  goal.inner_edges = static_cast<unsigned>(inner);
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

FoundReason Reasoner::find(Mask ports, const std::vector<Mask>& joined, const Choice& best,
                           std::uint64_t most_steps) const {
  const ReasonGoal goal = goal_of(ports, joined, best);
  ReasonSearch search(goal);
  std::optional<Reason> smallest = search.smallest(most_steps);
  const bool is_smallest = smallest.has_value();
  Reason reason = is_smallest ? *std::move(smallest) : search.greedy();
  return {std::move(reason), search.steps(), is_smallest};
}

}  // namespace restrip::generator
