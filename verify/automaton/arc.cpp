#include "automaton/arc.hpp"

namespace restrip::verify {

std::optional<std::size_t> number_of(Case c) {
  if (c == Case{'t', 't'}) return through;
  const std::size_t left = reaches.find(c.left);
  const std::size_t right = reaches.find(c.right);
  if (left == std::string_view::npos || right == std::string_view::npos) return {};
  return reaches.size() * left + right;
}

std::string ports_in(std::string_view word) {
  std::string ports;
  for (const char letter : word)
    if (has_port(letter)) ports += letter;
  return ports;
}

std::string end_ports(std::string_view word) {
  const std::string ports = ports_in(word);
  return ports.size() < 3 ? ports : ports.substr(0, 1) + "..";
}

int least_of(const Costs& costs) {
  std::optional<int> least;
  for (const auto& cost : costs)
    if (cost && (!least || *cost < *least)) least = cost;
  return least.value();
}

ArcColoring arc_coloring(std::string_view word, Mask links) {
  // Link j lies to the left of triangle j.
  const auto solid = [&](std::size_t link) { return is_solid(links, static_cast<unsigned>(link)); };
  const auto degree = [&](std::size_t i) {
    return (solid(i) ? 1 : 0) + (solid(i + 1) ? 1 : 0) + (has_port(word[i]) ? 1 : 0);
  };
  for (std::size_t i = 0; i < word.size(); ++i)
    if (degree(i) > (is_boundary(word[i]) ? 0 : 2)) return {};
  // Strands from port to port, along the links to the right, may only join what the letters join.
  for (std::size_t i = 0; i < word.size(); ++i) {
    if (!has_port(word[i])) continue;
    for (std::size_t at = i; at + 1 < word.size() && solid(at + 1);) {
      ++at;
      if (!has_port(word[at])) continue;
      if (!is_joined(word[at])) return {};
      break;
    }
  }

  ArcColoring coloring{true, 0, 0};
  for (std::size_t i = 0; i < word.size(); ++i) {
    if (solid(i)) coloring.cost -= strip_cost;
    if (degree(i) == 0 && !is_boundary(word[i])) coloring.cost += isolated_cost;
  }
  // The reach of the strand that enters triangle `at` over a link, from the left or from the right.
  const auto reach = [&](std::size_t at, bool rightwards) {
    for (;;) {
      if (has_port(word[at])) return 'p';
      if (!solid(rightwards ? at + 1 : at)) return 'e';
      if (rightwards ? at + 1 == word.size() : at == 0) return 't';
      at = rightwards ? at + 1 : at - 1;
    }
  };
  const Case found{solid(0) ? reach(0, true) : '-', solid(word.size()) ? reach(word.size() - 1, false) : '-'};
  coloring.arc_case = number_of(found).value();
  return coloring;
}

}  // namespace restrip::verify
