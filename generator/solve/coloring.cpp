#include "solve/coloring.hpp"

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

Coloring describe(const Side& side, Constraint constraint, Mask inner, const Partial& state) {
  Coloring coloring;
  coloring.inner = inner;
  std::vector<Mask> ports_of_node(side.nodes, 0);
  std::vector<Mask> ports_of_strip(side.nodes, 0);
  for (unsigned p = 0; p < side.owner.size(); ++p) {
    const unsigned node = side.owner[p];
    ports_of_node[node] |= bit(p);
    ports_of_strip[state.strip[node]] |= bit(p);
    if (state.degree[node] == constraint.most_edges) coloring.full |= bit(p);
  }
  for (unsigned node = 0; node < side.nodes; ++node) {
    if (state.degree[node] == 0) coloring.lonely.push_back(ports_of_node[node]);
    if (ports_of_strip[node] != 0) coloring.strips.push_back(ports_of_strip[node]);
    const int room = static_cast<int>(constraint.most_edges) - static_cast<int>(state.degree[node]);
    if (0 < room && room < std::popcount(ports_of_node[node])) coloring.crowds.push_back({ports_of_node[node], room});
  }
  return coloring;
}

void extend(const Side& side, Constraint constraint, unsigned edge, Mask inner, const Partial& state,
            std::vector<Coloring>& found) {
  if (edge == side.edges.size()) {
    found.push_back(describe(side, constraint, inner, state));
    return;
  }
  extend(side, constraint, edge + 1, inner, state, found);
  const auto [u, v] = side.edges[edge];
  const bool full = std::max(state.degree[u], state.degree[v]) == constraint.most_edges;
  if (full || state.strip[u] == state.strip[v]) return;
  Partial next = state;
  ++next.degree[u];
  ++next.degree[v];
  const auto [keep, drop] = std::minmax(state.strip[u], state.strip[v]);
  std::replace(next.strip.begin(), next.strip.end(), unsigned{drop}, unsigned{keep});
  extend(side, constraint, edge + 1, inner | bit(edge), next, found);
}

}  // namespace

std::vector<Coloring> legal_colorings(const Side& side, Constraint constraint) {
  Partial empty{std::vector<unsigned>(side.nodes, 0), std::vector<unsigned>(side.nodes)};
  std::iota(empty.strip.begin(), empty.strip.end(), 0U);
  std::vector<Coloring> found;
  extend(side, constraint, 0, 0, empty, found);
  std::sort(found.begin(), found.end(), [](const Coloring& x, const Coloring& y) { return x.inner < y.inner; });
  return found;
}

const Coloring* coloring_of(const std::vector<Coloring>& legal, Mask inner) {
  const auto found = std::lower_bound(legal.begin(), legal.end(), inner,
                                      [](const Coloring& one, Mask wanted) { return one.inner < wanted; });
  return found == legal.end() || found->inner != inner ? nullptr : &*found;
}

std::optional<Outcome> with_ports(const Coloring& coloring, Mask ports) {
  if ((coloring.full & ports) != 0) return std::nullopt;
  for (const auto& [of_node, room] : coloring.crowds)
    if (std::popcount(of_node & ports) > room) return std::nullopt;
  Outcome outcome;
  outcome.solid = static_cast<unsigned>(std::popcount(coloring.inner));
  for (const Mask node : coloring.lonely) outcome.isolated += (node & ports) == 0 ? 1U : 0U;
  for (const Mask strip : coloring.strips)
    for (Mask rest = strip & ports; rest != 0; rest &= rest - 1)
      for (Mask others = rest & (rest - 1); others != 0; others &= others - 1)
        outcome.joined.add(static_cast<unsigned>(std::countr_zero(rest)),
                           static_cast<unsigned>(std::countr_zero(others)));
  return outcome;
}

}  // namespace restrip::generator
