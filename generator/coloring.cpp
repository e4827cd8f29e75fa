#include "coloring.hpp"

#include <algorithm>
#include <bit>
#include <numeric>

namespace restrip::generator {
namespace {

Mask bit(unsigned i) { return Mask{1} << i; }

struct Partial {
  std::vector<unsigned> degree;
  std::vector<unsigned> strip;  // label: the smallest node of the strip
};

Coloring describe(const Side& side, Mask inner, const Partial& state) {
  Coloring coloring;
  coloring.inner = inner;
  std::vector<Mask> ports_of_node(side.nodes, 0);
  std::vector<Mask> ports_of_strip(side.nodes, 0);
  for (unsigned p = 0; p < side.owner.size(); ++p) {
    const unsigned node = side.owner[p];
    ports_of_node[node] |= bit(p);
    ports_of_strip[state.strip[node]] |= bit(p);
    if (state.degree[node] == 2) coloring.full |= bit(p);
    if (state.degree[node] == 1) coloring.exclusive |= bit(p);
  }
  for (unsigned node = 0; node < side.nodes; ++node) {
    if (state.degree[node] == 0) coloring.lonely.push_back(ports_of_node[node]);
    if (ports_of_strip[node] != 0) coloring.strips.push_back(ports_of_strip[node]);
  }
  return coloring;
}

void extend(const Side& side, unsigned edge, Mask inner, const Partial& state, std::vector<Coloring>& found) {
  if (edge == side.edges.size()) {
    found.push_back(describe(side, inner, state));
    return;
  }
  extend(side, edge + 1, inner, state, found);
  const auto [u, v] = side.edges[edge];
  if (state.degree[u] == 2 || state.degree[v] == 2 || state.strip[u] == state.strip[v]) return;
  Partial next = state;
  ++next.degree[u];
  ++next.degree[v];
  const auto [keep, drop] = std::minmax(state.strip[u], state.strip[v]);
  std::replace(next.strip.begin(), next.strip.end(), unsigned{drop}, unsigned{keep});
  extend(side, edge + 1, inner | bit(edge), next, found);
}

}  // namespace

std::vector<Coloring> legal_colorings(const Side& side) {
  Partial empty{std::vector<unsigned>(side.nodes, 0), std::vector<unsigned>(side.nodes)};
  std::iota(empty.strip.begin(), empty.strip.end(), 0U);
  std::vector<Coloring> found;
  extend(side, 0, 0, empty, found);
  std::sort(found.begin(), found.end(), [](const Coloring& x, const Coloring& y) { return x.inner < y.inner; });
  return found;
}

std::optional<Outcome> with_ports(const Side& side, const Coloring& coloring, Mask ports) {
  if ((coloring.full & ports) != 0) return std::nullopt;
  if (const Mask shared = coloring.exclusive & ports; shared != 0) {
    // Only a flip has nodes with two ports.
    for (unsigned p = 0; p < side.owner.size(); ++p)
      for (unsigned q = p + 1; q < side.owner.size(); ++q)
        if (side.owner[p] == side.owner[q] && (shared & bit(p)) != 0 && (shared & bit(q)) != 0) return std::nullopt;
  }
  Outcome outcome;
  outcome.solid = static_cast<unsigned>(std::popcount(coloring.inner));
  for (const Mask node : coloring.lonely) outcome.isolated += (node & ports) == 0 ? 1U : 0U;
  for (const Mask strip : coloring.strips)
    if (const Mask ends = strip & ports; std::popcount(ends) == 2) outcome.pairs.push_back(ends);
  return outcome;
}

Mask joined_to_previous(const std::vector<Mask>& pairs, Mask ports, unsigned k, bool closed, bool* leftover) {
  if (leftover != nullptr) *leftover = false;
  Mask joined = 0;
  for (const Mask pair : pairs) {
    bool consecutive = false;
    for (unsigned i = 0; i < k; ++i) {
      if ((pair & bit(i)) == 0) continue;
      // The nearest solid port below i, cyclic in a closed fan.
      const Mask below = ports & (bit(i) - 1);
      const Mask others = ports & ~bit(i);
      if (below == 0 && !(closed && others != 0)) continue;
      const Mask previous = std::bit_floor(below != 0 ? below : others);
      if ((pair & previous) != 0) {
        joined |= bit(i);
        consecutive = true;
      }
    }
    if (!consecutive && leftover != nullptr) *leftover = true;
  }
  return joined;
}

}  // namespace restrip::generator
