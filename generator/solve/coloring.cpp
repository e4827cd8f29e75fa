#include "solve/coloring.hpp"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <numeric>

namespace restrip::generator {

const std::array<PortPairs::Pair, PortPairs::most*(PortPairs::most - 1) / 2> PortPairs::pair_at = [] {
  std::array<Pair, most*(most - 1) / 2> pairs{};
  for (std::uint8_t low = 0; low < most; ++low)
    for (std::uint8_t high = low + 1; high < most; ++high) pairs[place_of(low, high)] = {low, high};
  return pairs;
}();

std::vector<Mask> PortPairs::masks() const {
  std::vector<Mask> pairs;
  visit([&](unsigned low, unsigned high) { pairs.push_back(Mask{1} << low | Mask{1} << high); });
  return pairs;
}

PortPairs PortPairs::moved(const std::vector<unsigned>& to) const {
  PortPairs image;
  visit([&](unsigned low, unsigned high) {
    const auto [a, b] = std::minmax(to[low], to[high]);
    image.add(a, b);
  });
  return image;
}

std::string PortPairs::text() const {
  std::array<unsigned, most*(most - 1) / 8> digits{};
  visit([&](unsigned low, unsigned high) {
    const unsigned place = written_place_of(low, high);
    digits[place / 4] |= 1U << place % 4;
  });
  std::string text;
  for (std::size_t i = digits.size(); i-- > 0;)
    if (!text.empty() || digits[i] != 0 || i == 0) text += "0123456789abcdef"[digits[i]];
  return text;
}

std::vector<Coloring> legal_colorings(const Side& side, Constraint constraint) {
  std::vector<Coloring> found;
  for (Mask inner = 0; inner < Mask{1} << side.edges.size(); ++inner) {
    std::vector<unsigned> degree(side.nodes, 0);
    std::vector<unsigned> strip(side.nodes);  // label: the smallest node of the strip
    std::iota(strip.begin(), strip.end(), 0U);
    bool legal = true;
    for (Mask rest = inner; legal && rest != 0; rest &= rest - 1) {
      const auto [u, v] = side.edges[static_cast<std::size_t>(std::countr_zero(rest))];
      const unsigned keep = std::min(strip[u], strip[v]);
      const unsigned drop = std::max(strip[u], strip[v]);
      legal = ++degree[u] <= constraint.most_edges && ++degree[v] <= constraint.most_edges && keep != drop;
      std::replace(strip.begin(), strip.end(), drop, keep);
    }
    if (!legal) continue;
    Coloring& coloring = found.emplace_back();
    coloring.inner = inner;
    std::vector<Mask> ports_of_node(side.nodes, 0);
    std::vector<Mask> ports_of_strip(side.nodes, 0);
    for (unsigned p = 0; p < side.owner.size(); ++p) {
      const unsigned node = side.owner[p];
      ports_of_node[node] |= Mask{1} << p;
      ports_of_strip[strip[node]] |= Mask{1} << p;
      if (degree[node] == constraint.most_edges) coloring.full |= Mask{1} << p;
    }
    for (unsigned node = 0; node < side.nodes; ++node) {
      const Mask ports = ports_of_node[node];
      if (degree[node] == 0) coloring.lonely.push_back(ports);
      if (ports_of_strip[node] != 0) coloring.strips.push_back(ports_of_strip[node]);
      const int room = static_cast<int>(constraint.most_edges) - static_cast<int>(degree[node]);
      if (0 < room && room < std::popcount(ports)) coloring.crowds.push_back({ports, room});
    }
  }
  return found;
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
