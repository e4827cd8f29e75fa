#include "forbidden_sets.hpp"

#include <algorithm>

#include "mutants.hpp"

namespace restrip::verify {
namespace {

unsigned edge_number(const Patch& patch, const DualEdge& edge) {
  return edge.kind == EdgeKind::inner ? edge.index : patch.inner_edges() + edge.index;
}

/// The edge sets of all simple paths of the bare patch from `at` to `goal` that avoid `used` nodes.
void collect_paths(const Patch& patch, Node at, Node goal, Mask used, Mask edges, std::vector<Mask>& paths) {
  if (at == goal) {
    paths.push_back(edges);
    return;
  }
  used |= single(static_cast<unsigned>(at));
  for (auto [edge, end] = boost::out_edges(at, patch.graph()); edge != end; ++edge) {
    const Node next = boost::target(*edge, patch.graph());
    if (is_solid(used, static_cast<unsigned>(next))) continue;
    collect_paths(patch, next, goal, used, edges | single(edge_number(patch, patch.graph()[*edge])), paths);
  }
}

std::vector<Mask> paths_between(const Patch& patch, Node from, Node to) {
  std::vector<Mask> paths;
  collect_paths(patch, from, to, 0, 0, paths);
  return paths;
}

std::vector<Mask> cycles_of(const Patch& patch) {
  std::vector<Mask> cycles;
  const DualGraph& graph = patch.graph();
  for (auto [edge, end] = boost::edges(graph); edge != end; ++edge) {
    const Mask closing = single(edge_number(patch, graph[*edge]));
    for (const Mask path : paths_between(patch, boost::source(*edge, graph), boost::target(*edge, graph)))
      if (path != closing) cycles.push_back(path | closing);
  }
  std::sort(cycles.begin(), cycles.end());
  cycles.erase(std::unique(cycles.begin(), cycles.end()), cycles.end());
  return cycles;
}

/// Some mutants forgive some cycles.
bool forgiven(const Patch& patch, Mask cycle) {
  if (mutated(Mutant::sets_drop_all_cycles)) return true;
  return mutated(Mutant::sets_drop_outer_cycle) && patch.chord() && !is_solid(cycle, *patch.chord());
}

bool contains_any(Mask edges, const std::vector<Mask>& sets) {
  return std::any_of(sets.begin(), sets.end(), [&](Mask set) { return is_subset(set, edges); });
}

/// Depth-first: some edge of the first set that is not hit yet has to be chosen. An edge tried before is not tried
/// again further on, so that each hitting set is found once.
void extend(const std::vector<Mask>& sets, Mask chosen, Mask given_up, unsigned budget, std::vector<Mask>& found) {
  const auto open = std::find_if(sets.begin(), sets.end(), [&](Mask set) { return (set & chosen) == 0; });
  if (open == sets.end()) {
    if (budget == 0) found.push_back(chosen);
    return;
  }
  if (budget == 0) return;
  Mask choices = *open & ~given_up;
  while (choices != 0) {
    const Mask edge = choices & (~choices + 1);
    extend(sets, chosen | edge, given_up, budget - 1, found);
    given_up |= edge;
    choices &= ~edge;
  }
}

}  // namespace

Mask edge_set(const Patch& patch, Coloring colors) {
  return concatenated(colors.ports, colors.inner, patch.inner_edges());
}

ForbiddenSets::ForbiddenSets(const Patch& patch) : patch_(patch) {
  const DualGraph& graph = patch.graph();
  for (const Node triangle : patch.triangles()) {
    Mask edges = 0;
    for (auto [edge, end] = boost::out_edges(triangle, graph); edge != end; ++edge)
      edges |= single(edge_number(patch, graph[*edge]));
    edges_of_triangles_.push_back(edges);
    if (solid_count(edges) == 3 && !mutated(Mutant::sets_loosen_degree)) always_.push_back(edges);
  }
  for (const Mask cycle : cycles_of(patch))
    if (!forgiven(patch, cycle)) always_.push_back(cycle);
  for (unsigned from = 0; from < patch.ports(); ++from)
    for (unsigned to = from + 1; to < patch.ports(); ++to)
      for (const Mask path : paths_between(patch, patch.outside()[from], patch.outside()[to]))
        paths_.push_back({from, to, path});
  if (mutated(Mutant::sets_drop_path) && !paths_.empty()) paths_.pop_back();
}

bool ForbiddenSets::valid(Mask solid_edges) const { return !contains_any(solid_edges, always_); }

PortPairs ForbiddenSets::joined(Mask solid_edges) const {
  PortPairs pairs;
  for (const PathBetweenPorts& path : paths_)
    if (is_subset(path.edges, solid_edges)) pairs.add(path.from, path.to);
  return pairs;
}

std::vector<Mask> ForbiddenSets::forbidden(Mask ports, PortPairs may_be_joined) const {
  const Mask possible = edge_set(patch_, {mask_count(patch_.inner_edges()) - 1, ports});
  std::vector<Mask> sets;
  for (const Mask set : always_)
    if (is_subset(set, possible)) sets.push_back(set);
  for (const PathBetweenPorts& path : paths_)
    if (is_subset(path.edges, possible) && !may_be_joined.has(path.from, path.to)) sets.push_back(path.edges);
  std::vector<Mask> smallest;
  for (const Mask set : sets)
    if (std::none_of(sets.begin(), sets.end(), [&](Mask other) { return other != set && is_subset(other, set); }))
      smallest.push_back(set);
  return smallest;
}

std::vector<Mask> smallest_hitting_sets(const std::vector<Mask>& sets, Mask universe) {
  std::vector<Mask> within(sets);
  for (Mask& set : within) set &= universe;
  // Small sets first: they leave the fewest choices.
  std::stable_sort(within.begin(), within.end(), [](Mask a, Mask b) { return solid_count(a) < solid_count(b); });
  if (!within.empty() && within.front() == 0) return {};
  std::vector<Mask> found;
  for (unsigned size = 0; found.empty(); ++size) extend(within, 0, 0, size, found);
  return found;
}

}  // namespace restrip::verify
