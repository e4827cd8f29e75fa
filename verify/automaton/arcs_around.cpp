#include "arcs_around.hpp"

#include <algorithm>
#include <optional>
#include <string>

namespace restrip::verify {
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

  /// Where the strip that starts at this node of degree one ends; marks what it passes.
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

  /// With degrees at most two: whether some nodes lie on no strip that has an end, or two edges join the same nodes.
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

constexpr std::size_t node_a = 0;
constexpr std::size_t node_d = 1;

struct PortNode {
  std::size_t node = 0;
  ArcEnd end;
};

/// Adds what a case does between its left and its right neighbour.
void add_arc(SmallGraph& graph, Case c, std::size_t left, std::size_t right, bool second_arc,
             std::vector<PortNode>& ports) {
  if (c.left == 't') {
    const std::size_t strand = graph.add_node();
    graph.add_edge(left, strand);
    graph.add_edge(strand, right);
    return;
  }
  const auto add_strand = [&](char reach, std::size_t neighbor, bool is_right) {
    if (reach == '-') return;
    const std::size_t strand = graph.add_node();
    graph.add_edge(neighbor, strand);
    if (reach == 'p') ports.push_back({strand, {second_arc, is_right}});
  };
  add_strand(c.left, left, false);
  add_strand(c.right, right, true);
}

bool has_port(char letter) { return letter == 's' || letter == 'j'; }

}  // namespace

Around around(std::size_t first, std::size_t second, bool chord) {
  Around result{first, second, chord, false, {}, {}};
  const Case x = all_cases[first];
  const Case y = all_cases[second];
  SmallGraph graph;
  std::vector<PortNode> ports;
  add_arc(graph, x, node_a, node_d, false, ports);
  add_arc(graph, y, node_d, node_a, true, ports);
  if (chord) graph.add_edge(node_a, node_d);
  result.worth.solid = (x.right != '-' ? 1 : 0) + (y.right != '-' ? 1 : 0) + (chord ? 1 : 0);
  result.worth.fewer_isolated = -((graph.degree(node_a) == 0 ? 1 : 0) + (graph.degree(node_d) == 0 ? 1 : 0));
  if (graph.degree(node_a) > 2 || graph.degree(node_d) > 2 || graph.has_cycle()) return result;
  result.legal = true;
  for (std::size_t i = 0; i < ports.size(); ++i) {
    std::vector<bool> visited(graph.size(), false);
    const std::size_t other = graph.walk(ports[i].node, visited);
    for (std::size_t j = i + 1; j < ports.size(); ++j)
      if (ports[j].node == other) result.joined.emplace_back(ports[i].end, ports[j].end);
  }
  return result;
}

const std::vector<Around>& all_around() {
  static const std::vector<Around> all = [] {
    std::vector<Around> list;
    for (std::size_t x = 0; x < all_cases.size(); ++x)
      for (std::size_t y = 0; y < all_cases.size(); ++y)
        for (const bool chord : {false, true})
          if (Around way = around(x, y, chord); way.legal) list.push_back(std::move(way));
    return list;
  }();
  return all;
}

namespace {

/// The solid ports of the ring, and those that two links reach: the nearest solid ones of their arcs.
struct RingPorts {
  std::string ring;
  std::vector<std::size_t> places;
  std::optional<std::size_t> one;    ///< in `places`
  std::optional<std::size_t> other;  ///< in `places`

  RingPorts(std::string_view first, std::string_view second, ArcEnd one_end, ArcEnd other_end) : ring(first) {
    ring += second;
    for (std::size_t i = 0; i < ring.size(); ++i)
      if (has_port(ring[i])) places.push_back(i);
    const auto reached = [&](ArcEnd end) {
      std::optional<std::size_t> found;
      for (std::size_t n = 0; n < places.size(); ++n) {
        if ((places[n] >= first.size()) != end.second_arc) continue;
        if (!found || end.right) found = n;
      }
      return found;
    };
    one = reached(one_end);
    other = reached(other_end);
  }

  bool are_two() const { return one && other && *one != *other; }
  bool follows(std::size_t later, std::size_t earlier) const { return (earlier + 1) % places.size() == later; }
  bool boundary_between(std::size_t earlier, std::size_t later) const {
    for (std::size_t at = places[earlier]; at != places[later]; at = (at + 1) % ring.size())
      if (ring[at] == 'b') return true;
    return false;
  }
};

}  // namespace

bool joined_before(std::string_view first, std::string_view second, ArcEnd one, ArcEnd other) {
  const RingPorts ports(first, second, one, other);
  if (!ports.are_two()) return false;
  const auto joined = [&](std::size_t later, std::size_t earlier) {
    return ports.follows(later, earlier) && ports.ring[ports.places[later]] == 'j';
  };
  return joined(*ports.one, *ports.other) || joined(*ports.other, *ports.one);
}

bool in_key(std::string_view first, std::string_view second, ArcEnd one, ArcEnd other) {
  const RingPorts ports(first, second, one, other);
  if (!ports.are_two()) return false;
  const auto next = [&](std::size_t later, std::size_t earlier) {
    return ports.follows(later, earlier) && !ports.boundary_between(earlier, later);
  };
  return next(*ports.one, *ports.other) || next(*ports.other, *ports.one);
}

}  // namespace restrip::verify
