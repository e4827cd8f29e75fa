#include "outside.hpp"

#include <numeric>
#include <optional>

#include "mutants.hpp"

namespace restrip::verify {
namespace {

constexpr unsigned most_ports = 8;

/// Extends `chosen` in all ways by pairs of `open` ports.
void extend(Mask open, PortPairs chosen, std::vector<PortPairs>& all) {
  all.push_back(chosen);
  if (mutated(Mutant::outside_one_pair) && chosen.bits != 0) return;
  // The next pair's lower port is above those of all pairs before, so that no set comes twice.
  for (unsigned low = 0; low < most_ports; ++low) {
    if (!is_solid(open, low)) continue;
    open &= ~single(low);
    for (unsigned high = low + 1; high < most_ports; ++high) {
      if (!is_solid(open, high)) continue;
      PortPairs more = chosen;
      more.add(low, high);
      extend(open & ~single(high), more, all);
    }
  }
}

std::optional<unsigned> partner(PortPairs pairs, unsigned port, unsigned ports) {
  for (unsigned other = 0; other < ports; ++other)
    if (other != port && pairs.has(port, other)) return other;
  return {};
}

}  // namespace

std::vector<PortPairs> matchings_of(Mask ports) {
  std::vector<PortPairs> all;
  extend(ports, {}, all);
  return all;
}

World::World(const Patch& patch, Mask ports, PortPairs outside)
    : triangles_(patch.triangles()), inner_(patch.inner_edges()) {
  const DualGraph& graph = patch.graph();
  for (auto [edge, end] = boost::edges(graph); edge != end; ++edge) {
    const Ends ends{boost::source(*edge, graph), boost::target(*edge, graph)};
    if (graph[*edge].kind == EdgeKind::inner)
      inner_[graph[*edge].index] = ends;
    else if (is_solid(ports, graph[*edge].index))
      always_.push_back(ends);
  }
  for (unsigned i = 0; i < patch.ports(); ++i)
    for (unsigned j = i + 1; j < patch.ports(); ++j)
      if (outside.has(i, j) && !mutated(Mutant::outside_ignored))
        always_.push_back({patch.outside()[i], patch.outside()[j]});
}

World::View World::look(Mask inner) const {
  std::array<unsigned, most_nodes> degree{};
  std::array<Node, most_nodes> parent;
  std::iota(parent.begin(), parent.end(), Node{0});
  bool closes = false;
  const auto root = [&](Node node) {
    while (parent[node] != node) node = parent[node];
    return node;
  };
  // An edge between two nodes that are connected already closes a cycle.
  const auto lay = [&](Ends ends) {
    ++degree[ends.one];
    ++degree[ends.other];
    const Node one = root(ends.one);
    const Node other = root(ends.other);
    closes = closes || one == other;
    parent[one] = other;
  };
  for (const Ends ends : always_) lay(ends);
  for (unsigned i = 0; i < inner_.size(); ++i)
    if (is_solid(inner, i)) lay(inner_[i]);
  View view{!closes, 0};
  for (const Node node : triangles_) {
    view.sound = view.sound && degree[node] <= 2;
    view.isolated += degree[node] == 0 ? 1 : 0;
  }
  return view;
}

bool close_a_cycle(PortPairs one, PortPairs other, unsigned ports) {
  for (unsigned start = 0; start < ports; ++start)
    for (std::optional<unsigned> at = start; at;) {
      at = partner(one, *at, ports);
      if (at) at = partner(other, *at, ports);
      if (at == start) return !mutated(Mutant::forget_partners);
    }
  return false;
}

}  // namespace restrip::verify
