// The least cost of a recolouring for patches too large to look at every colouring, where swaps have a price.
// Walks along the row of nodes and keeps, for every different way in which the strands so far hang together and turn,
// the least cost.
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "naive_turns.hpp"

namespace naive {

class TurnFrontier {
 public:
  TurnFrontier(const TurnPatch& patch, const Bits& ports, const Bits& joined, Behind behind, Weights weights)
      : patch_(patch),
        ports_(ports),
        behind_(std::move(behind)),
        weights_(weights),
        allowed_(pairs_of(patch.graph, ports, joined)) {}

  int least() const {
    const Patch& graph = patch_.graph;
    const bool chord = graph.edges.size() > graph.nodes - (graph.cyclic ? 0 : 1);
    std::optional<int> result;
    for (int use_closing = 0; use_closing <= (graph.cyclic ? 1 : 0); ++use_closing) {
      for (int use_chord = 0; use_chord <= (chord ? 1 : 0); ++use_chord) {
        const auto least = least_with(use_closing != 0, use_chord != 0);
        if (least && (!result || *least < *result)) result = least;
      }
    }
    return result.value();
  }

 private:
  // The halves of edges that wait for their node: the edge to the next node of the row, the chord at A and at D, the
  // edge that closes a ring at the first node and at the last.
  enum Half : int { row_edge, chord_a, chord_d, closing_first, closing_last, halves };
  static constexpr std::size_t at(Half half) { return static_cast<std::size_t>(half); }
  static constexpr int absent = -1;   // no such half
  static constexpr int nothing = -2;  // a node where the strand ends
  static constexpr int first_port = 100;

  // What a half's strand leads to at its other end: another half, one of the above, or a port; and the corner about
  // which the strip passes the triangle on the other side of the half's edge, once it is known.
  struct State {
    std::array<int, halves> end;
    std::array<Corner, halves> corner;
    friend auto operator<=>(const State&, const State&) = default;
  };

  std::optional<int> least_with(bool closing, bool chord) const {
    const Patch& graph = patch_.graph;
    State start;
    start.end.fill(absent);
    start.corner.fill(no_corner);
    int base = weights_.restart * static_cast<int>(graph.nodes);
    const auto begin = [&](Half one, Half other) {
      start.end[at(one)] = other;
      start.end[at(other)] = one;
      base -= weights_.restart;
    };
    if (closing) begin(closing_first, closing_last);
    if (chord) begin(chord_a, chord_d);
    std::map<State, int> states{{start, base}};
    std::size_t port = 0;
    for (std::size_t node = 0; node < graph.nodes; ++node) {
      std::map<State, int> next;
      const bool has_port = port < graph.port_node.size() && graph.port_node[port] == node;
      for (const auto& [state, cost] : states) {
        for (int onward = 0; onward <= (node + 1 < graph.nodes ? 1 : 0); ++onward) {
          step(state, cost, node, has_port && ports_[port] ? std::optional(port) : std::nullopt, onward != 0, chord,
               next);
        }
      }
      if (has_port) ++port;
      states.swap(next);
    }
    std::optional<int> result;
    for (const auto& entry : states) {
      if (!result || entry.second < *result) result = entry.second;
    }
    return result;
  }

  // Ties together all that meets at one node.
  void step(State state, int cost, std::size_t node, std::optional<std::size_t> port, bool onward, bool chord,
            std::map<State, int>& next) const {
    const Patch& graph = patch_.graph;
    struct Waiting {
      Half half;
      Half other;  // the half of the same edge that keeps the corner of this node; itself where nobody waits for it
      Edge edge;
    };
    std::vector<Waiting> here;
    if (state.end[row_edge] != absent) here.push_back({row_edge, row_edge, patch_.inner(node - 1)});
    if (chord && graph.edges.back().first == node)
      here.push_back({chord_a, chord_d, patch_.inner(graph.edges.size() - 1)});
    if (chord && graph.edges.back().second == node)
      here.push_back({chord_d, chord_d, patch_.inner(graph.edges.size() - 1)});
    if (node == 0 && state.end[closing_first] != absent)
      here.push_back({closing_first, closing_last, patch_.inner(graph.nodes - 1)});
    if (node + 1 == graph.nodes && state.end[closing_last] != absent)
      here.push_back({closing_last, closing_last, patch_.inner(graph.nodes - 1)});
    const std::size_t degree = here.size() + (port ? 1 : 0) + (onward ? 1 : 0);
    if (degree > 2) return;
    if (here.size() == 2 && state.end[at(here[0].half)] == here[1].half) return;  // a cycle

    Corner corner = no_corner;
    if (degree == 2) {
      std::vector<Edge> edges;
      edges.reserve(2);
      for (const Waiting& waiting : here) edges.push_back(waiting.edge);
      if (port) edges.push_back(patch_.ports[*port]);
      if (onward) edges.push_back(patch_.inner(node));
      corner = common(edges[0], edges[1]);
    }
    if (degree == 0) cost += weights_.isolated;
    if (port && corner != no_corner && corner == behind_[*port]) cost += weights_.swap;
    std::vector<int> ends;
    ends.reserve(2);
    for (const Waiting& waiting : here) {
      if (corner != no_corner && corner == state.corner[at(waiting.half)]) cost += weights_.swap;
      ends.push_back(state.end[at(waiting.half)]);
    }
    for (const Waiting& waiting : here) {
      state.end[at(waiting.half)] = absent;
      state.corner[at(waiting.half)] = no_corner;
    }
    for (const Waiting& waiting : here) {
      if (waiting.other != waiting.half) state.corner[at(waiting.other)] = corner;
    }
    if (port) ends.push_back(first_port + static_cast<int>(*port));
    if (onward) {
      if (ends.empty()) ends.push_back(nothing);
      state.end[row_edge] = ends[0];
      state.corner[row_edge] = corner;
      if (ends[0] >= 0 && ends[0] < halves) state.end[static_cast<std::size_t>(ends[0])] = row_edge;
      cost -= weights_.restart;
    } else {
      while (ends.size() < 2) ends.push_back(nothing);
      if (!tie(state, ends[0], ends[1]) || !tie(state, ends[1], ends[0])) return;
    }
    const auto [place, is_new] = next.emplace(state, cost);
    if (!is_new && cost < place->second) place->second = cost;
  }

  bool tie(State& state, int one, int two) const {
    if (one >= 0 && one < halves) state.end[static_cast<std::size_t>(one)] = two;
    if (one < first_port || two < first_port || one > two) return true;
    return allowed_.count({static_cast<std::size_t>(one - first_port), static_cast<std::size_t>(two - first_port)}) !=
           0;
  }

  const TurnPatch& patch_;
  Bits ports_;
  Behind behind_;
  Weights weights_;
  Pairs allowed_;
};

}  // namespace naive
