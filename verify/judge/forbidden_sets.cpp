#include "judge/forbidden_sets.hpp"

#include <algorithm>

namespace restrip::verify {
namespace {

/// The bare side as a graph: its triangles, and behind each port a node of its own.
struct BareGraph {
  struct Way {
    unsigned to;
    Mask edge;
  };
  std::vector<std::vector<Way>> ways;

  explicit BareGraph(const Side& side) : ways(side.triangles + side.ports()) {
    for (unsigned i = 0; i < side.inner_edges(); ++i) join(side.edges[i][0], side.edges[i][1], single(i));
    for (unsigned i = 0; i < side.ports(); ++i)
      join(side.owner_of_port[i], side.triangles + i, single(side.inner_edges() + i));
  }
  void join(unsigned one, unsigned other, Mask edge) {
    ways[one].push_back({other, edge});
    ways[other].push_back({one, edge});
  }
};

/// The edge sets of all simple paths from `at` to `goal` that avoid `used` nodes.
void collect_paths(const BareGraph& graph, unsigned at, unsigned goal, Mask used, Mask edges,
                   std::vector<Mask>& paths) {
  if (at == goal) {
    paths.push_back(edges);
    return;
  }
  used |= single(at);
  for (const BareGraph::Way& way : graph.ways[at])
    if (!is_solid(used, way.to)) collect_paths(graph, way.to, goal, used, edges | way.edge, paths);
}

std::vector<Mask> paths_between(const BareGraph& graph, unsigned from, unsigned to) {
  std::vector<Mask> paths;
  collect_paths(graph, from, to, 0, 0, paths);
  return paths;
}

std::vector<Mask> cycles_of(const Side& side, const BareGraph& graph) {
  std::vector<Mask> cycles;
  for (unsigned i = 0; i < side.inner_edges(); ++i)
    for (const Mask path : paths_between(graph, side.edges[i][0], side.edges[i][1]))
      if (path != single(i)) cycles.push_back(path | single(i));
  std::sort(cycles.begin(), cycles.end());
  cycles.erase(std::unique(cycles.begin(), cycles.end()), cycles.end());
  return cycles;
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

Mask edge_set(const Side& side, Colors colors) { return concatenated(colors.ports, colors.inner, side.inner_edges()); }

ForbiddenSets::ForbiddenSets(const Side& side) : side_(side) {
  const BareGraph graph(side);
  for (unsigned triangle = 0; triangle < side.triangles; ++triangle) {
    Mask edges = 0;
    for (const BareGraph::Way& way : graph.ways[triangle]) edges |= way.edge;
    edges_of_triangles_.push_back(edges);
    if (solid_count(edges) == 3) always_.push_back(edges);
  }
  for (const Mask cycle : cycles_of(side, graph)) always_.push_back(cycle);
  for (unsigned from = 0; from < side.ports(); ++from)
    for (unsigned to = from + 1; to < side.ports(); ++to)
      for (const Mask path : paths_between(graph, side.triangles + from, side.triangles + to))
        paths_.push_back({from, to, path});
}

bool ForbiddenSets::valid(Mask solid_edges) const { return !contains_any(solid_edges, always_); }

PortPairs ForbiddenSets::joined(Mask solid_edges) const {
  PortPairs pairs;
  for (const PathBetweenPorts& path : paths_)
    if (is_subset(path.edges, solid_edges)) pairs.add(path.from, path.to);
  return pairs;
}

std::vector<Mask> ForbiddenSets::forbidden(Mask ports, PortPairs may_be_joined) const {
  const Mask possible = edge_set(side_, {mask_count(side_.inner_edges()) - 1, ports});
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
