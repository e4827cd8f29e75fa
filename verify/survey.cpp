#include "survey.hpp"

#include <fmt/format.h>

#include <array>
#include <boost/graph/graph_traits.hpp>

#include "mutants.hpp"

namespace restrip::verify {
namespace {

// Nodes that strips have been followed through. A patch has at most 8 + 2 triangles and 8 outside nodes.
using Visited = std::array<bool, 24>;

unsigned solid_degree(const Patch& patch, Coloring colors, Node node) {
  unsigned degree = 0;
  for (auto [edge, end] = boost::out_edges(node, patch.graph()); edge != end; ++edge)
    degree += solid(patch.graph()[*edge], colors) ? 1U : 0U;
  return degree;
}

unsigned allowed_degree(const Patch& patch, Node node) {
  if (mutated(Mutant::loosen_degree)) return 3;
  if (mutated(Mutant::loosen_new_degree)) {
    const std::string& name = patch.graph()[node].name;
    return name == "A" || name == "D" ? 3 : 2;
  }
  return 2;
}

/// Marks the strip that `node` lies on; returns the last node reached, which is the other end when `node` is an end.
Node follow(const Patch& patch, Coloring colors, Node node, Visited& visited) {
  const DualGraph& graph = patch.graph();
  while (true) {
    visited[node] = true;
    bool moved = false;
    for (auto [edge, end] = boost::out_edges(node, graph); edge != end && !moved; ++edge) {
      const Node next = boost::target(*edge, graph);
      if (!solid(graph[*edge], colors) || visited[next]) continue;
      node = next;
      moved = true;
    }
    if (!moved) return node;
  }
}

bool uses_chord(const Patch& patch, Coloring colors) { return patch.chord() && is_solid(colors.inner, *patch.chord()); }

/// Some mutants forgive some cycles.
bool forgiven(const Patch& patch, Coloring colors) {
  if (mutated(Mutant::drop_all_cycles)) return true;
  if (mutated(Mutant::drop_outer_cycle)) return patch.chord() && !uses_chord(patch, colors);
  if (mutated(Mutant::drop_chord_cycles)) return uses_chord(patch, colors);
  return false;
}

}  // namespace

Survey survey(const Patch& patch, Coloring colors) {
  const DualGraph& graph = patch.graph();
  Survey result;
  result.solid = static_cast<std::uint8_t>(solid_count(colors.inner));

  std::array<unsigned, 24> degree{};
  for (const Node node : patch.triangles()) {
    degree[node] = solid_degree(patch, colors, node);
    if (degree[node] > allowed_degree(patch, node)) return result;
    if (degree[node] == 0) ++result.isolated;
  }

  // Every strip that has an end is walked from it; what is left over afterwards can only lie on cycles.
  Visited visited{};
  for (unsigned port = 0; port < patch.ports(); ++port) {
    const Node start = patch.outside()[port];
    if (!is_solid(colors.ports, port) || visited[start]) continue;
    const Node finish = follow(patch, colors, start, visited);
    if (graph[finish].outside) result.joined.add(port, graph[finish].port);
  }
  for (const Node node : patch.triangles())
    if (degree[node] <= 1 && !visited[node]) follow(patch, colors, node, visited);
  for (const Node node : patch.triangles())
    if (!visited[node] && !forgiven(patch, colors)) return result;

  result.valid = true;
  return result;
}

std::string fault_of(const Patch& patch, Coloring colors) {
  if (survey(patch, colors).valid) return {};
  for (const Node node : patch.triangles())
    if (const unsigned degree = solid_degree(patch, colors, node); degree > 2)
      return fmt::format("triangle {} has {} solid edges", patch.graph()[node].name, degree);
  return "a strip closes inside the patch";
}

}  // namespace restrip::verify
