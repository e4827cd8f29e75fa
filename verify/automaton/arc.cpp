#include "automaton/arc.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

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

namespace {

/// Nodes of the small graph: A and D, then one for each strand of an arc.
class SmallGraph {
 public:
  SmallGraph() : neighbors_(2) {}

  std::size_t add_node() {
    neighbors_.emplace_back();
    return neighbors_.size() - 1;
  }
  void add_edge(std::size_t x, std::size_t y) {
    neighbors_[x].push_back(y);
    neighbors_[y].push_back(x);
  }
  std::size_t degree(std::size_t x) const { return neighbors_[x].size(); }

  /// The end of the strip that starts at this node of degree one; marks the nodes on it.
  std::size_t walk(std::size_t from, std::vector<bool>& visited) const {
    visited[from] = true;
    for (std::size_t at = from;;) {
      const auto next =
          std::find_if(neighbors_[at].begin(), neighbors_[at].end(), [&](std::size_t node) { return !visited[node]; });
      if (next == neighbors_[at].end()) return at;
      at = *next;
      visited[at] = true;
    }
  }

  /// For degrees at most two: whether some nodes lie on no strip with an end, or two edges join the same nodes.
  bool has_cycle() const {
    std::vector<bool> visited(neighbors_.size(), false);
    for (std::size_t node = 0; node < neighbors_.size(); ++node)
      if (degree(node) <= 1 && !visited[node]) walk(node, visited);
    return std::find(visited.begin(), visited.end(), false) != visited.end();
  }
  std::size_t size() const { return neighbors_.size(); }

 private:
  std::vector<std::vector<std::size_t>> neighbors_;
};

/// Pairs of links as bits.
Mask pair_of_ends(ArcEnd one, ArcEnd other) {
  return static_cast<Mask>(PortPairs::of(one, other).bits);  // of four ends
}

constexpr std::size_t node_a = 0;
constexpr std::size_t node_d = 1;

ArcWay way_around(std::size_t first, std::size_t second, bool chord) {
  const Case x = case_at(first);
  const Case y = case_at(second);
  SmallGraph graph;
  std::vector<std::pair<std::size_t, ArcEnd>> ports;  // strands that leave by ports
  const auto add_strand = [&](char reach, std::size_t neighbor, ArcEnd end) {
    if (reach == '-') return;
    const std::size_t strand = graph.add_node();
    graph.add_edge(neighbor, strand);
    if (reach == 'p') ports.emplace_back(strand, end);
  };
  const auto add_arc = [&](Case c, std::size_t left, std::size_t right, ArcEnd left_end, ArcEnd right_end) {
    if (c.left != 't') {
      add_strand(c.left, left, left_end);
      add_strand(c.right, right, right_end);
      return;
    }
    const std::size_t strand = graph.add_node();
    graph.add_edge(left, strand);
    graph.add_edge(strand, right);
  };
  add_arc(x, node_a, node_d, first_left, first_right);
  add_arc(y, node_d, node_a, second_left, second_right);
  if (chord) graph.add_edge(node_a, node_d);
  ArcWay way;
  way.legal = graph.degree(node_a) <= 2 && graph.degree(node_d) <= 2 && !graph.has_cycle();
  for (std::size_t i = 0; way.legal && i < ports.size(); ++i) {
    std::vector<bool> visited(graph.size(), false);
    const std::size_t other = graph.walk(ports[i].first, visited);
    for (std::size_t j = i + 1; j < ports.size(); ++j)
      if (ports[j].first == other) way.joined |= pair_of_ends(ports[i].second, ports[j].second);
  }
  const int edges = (x.right != '-' ? 1 : 0) + (y.right != '-' ? 1 : 0) + (chord ? 1 : 0);
  const int isolated = (graph.degree(node_a) == 0 ? 1 : 0) + (graph.degree(node_d) == 0 ? 1 : 0);
  way.cost = isolated_cost * isolated - strip_cost * edges;
  return way;
}

/// The two links are one edge: a strand over it that leaves by ports at both ends joins them, and one that goes through
/// is a cycle.
ArcWay way_closed(std::size_t c) {
  const Case k = case_at(c);
  ArcWay way;
  way.legal = (k.left == '-') == (k.right == '-') && k.left != 't';
  if (way.legal && k.left == 'p' && k.right == 'p') way.joined = pair_of_ends(first_left, first_right);
  return way;
}

}  // namespace

ArcWays::ArcWays() {
  for (std::size_t x = 0; x < case_count; ++x)
    for (std::size_t y = 0; y < case_count; ++y)
      for (const bool chord : {false, true}) around_.push_back(way_around(x, y, chord));
  for (std::size_t c = 0; c < case_count; ++c) closed_.push_back(way_closed(c));
}

bool joined_before(std::string_view first, std::string_view second, ArcEnd one, ArcEnd other) {
  // The solid ports of the ring, beginning with the first arc; a link reaches the nearest one of its arc.
  const std::size_t of_first = ports_in(first).size();
  const std::string ring = ports_in(first) + ports_in(second);
  const auto reached = [&](ArcEnd end) -> std::optional<std::size_t> {
    const std::size_t from = end >= second_left ? of_first : 0;
    const std::size_t to = end >= second_left ? ring.size() : of_first;
    if (from == to) return {};
    return end == first_left || end == second_left ? from : to - 1;
  };
  const std::optional<std::size_t> a = reached(one);
  const std::optional<std::size_t> b = reached(other);
  const auto follows = [&](std::size_t later, std::size_t earlier) {
    return (earlier + 1) % ring.size() == later && is_joined(ring[later]);
  };
  return a && b && *a != *b && (follows(*a, *b) || follows(*b, *a));
}

Mask pairs_joined_before(std::string_view first, std::string_view second) {
  Mask pairs = 0;
  for (const ArcEnd one : {first_left, first_right, second_left})
    for (const ArcEnd other : {first_right, second_left, second_right})
      if (one < other && joined_before(first, second, one, other)) pairs |= pair_of_ends(one, other);
  return pairs;
}

}  // namespace restrip::verify
