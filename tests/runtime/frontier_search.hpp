// A second way to the best recolouring, for patches too large to look at every colouring: walk along the row of nodes
// and keep, for every different way in which the strands so far hang together, the best cost. Simple rather than fast:
// the ways are kept in a std::map, nothing is known about arcs, and every solid edge that is not finished has two loose
// halves.
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "naive_patch.hpp"

namespace naive {

class FrontierSearch {
 public:
  // The patch must come from row(): edge m joins nodes m and m+1, a ring's next edge closes it, a chord comes last.
  FrontierSearch(const Patch& patch, const Bits& ports, const Bits& joined)
      : patch_(patch), ports_(ports), allowed_(pairs_of(patch, ports, joined)) {}

  // Most solid edges, then fewest isolated nodes: solid * 10^6 - isolated.
  long best() const {
    const bool chord = patch_.edges.size() > patch_.nodes - (patch_.cyclic ? 0 : 1);
    long result = -1;
    for (int use_closing = 0; use_closing <= (patch_.cyclic ? 1 : 0); ++use_closing) {
      for (int use_chord = 0; use_chord <= (chord ? 1 : 0); ++use_chord) {
        result = std::max(result, best_with(use_closing != 0, use_chord != 0));
      }
    }
    return result;
  }

 private:
  // The halves of edges that wait for their node. What a half's strand leads to at its other end: another half (its
  // number), or one of these, or a port.
  enum Half : int { row_edge, chord_a, chord_d, closing_first, closing_last, halves };
  static constexpr int absent = -1;   // no such half
  static constexpr int nothing = -2;  // a node where the strand ends
  static constexpr int first_port = 100;
  using State = std::array<int, halves>;

  long best_with(bool closing, bool chord) const {
    State start;
    start.fill(absent);
    long base = 0;
    if (closing) {
      start[closing_first] = closing_last;
      start[closing_last] = closing_first;
      base += 1000000;
    }
    if (chord) {
      start[chord_a] = chord_d;
      start[chord_d] = chord_a;
      base += 1000000;
    }
    std::vector<int> port_at(patch_.nodes, -1);
    for (std::size_t i = 0; i < patch_.port_node.size(); ++i) {
      if (ports_[i]) port_at[patch_.port_node[i]] = first_port + static_cast<int>(i);
    }
    std::map<State, long> states{{start, base}};
    for (std::size_t node = 0; node < patch_.nodes; ++node) {
      std::map<State, long> next;
      for (const auto& [state, cost] : states) {
        for (int onward = 0; onward <= (node + 1 < patch_.nodes ? 1 : 0); ++onward) {
          step(state, cost, node, port_at[node], onward != 0, chord, next);
        }
      }
      states.swap(next);
    }
    long result = -1;
    for (const auto& entry : states) result = std::max(result, entry.second);
    return result;
  }

  // Ties together all that meets at one node.
  void step(State state, long cost, std::size_t node, int port, bool onward, bool chord,
            std::map<State, long>& next) const {
    std::vector<int> here;  // waiting halves that end at this node
    if (state[row_edge] != absent) here.push_back(row_edge);
    if (chord && patch_.edges.back().first == node) here.push_back(chord_a);
    if (chord && patch_.edges.back().second == node) here.push_back(chord_d);
    if (node == 0 && state[closing_first] != absent) here.push_back(closing_first);
    if (node + 1 == patch_.nodes && state[closing_last] != absent) here.push_back(closing_last);
    const std::size_t degree = here.size() + (port >= 0 ? 1 : 0) + (onward ? 1 : 0);
    if (degree > 2) return;
    if (here.size() == 2 && state[static_cast<std::size_t>(here[0])] == here[1]) return;  // a cycle
    std::vector<int> ends;
    ends.reserve(here.size() + 1);
    for (const int half : here) ends.push_back(state[static_cast<std::size_t>(half)]);
    for (const int half : here) state[static_cast<std::size_t>(half)] = absent;
    if (port >= 0) ends.push_back(port);
    if (onward) {
      // The row edge is free again: a new strand begins in its place.
      if (ends.empty()) ends.push_back(nothing);
      state[row_edge] = ends[0];
      if (ends[0] >= 0 && ends[0] < halves) state[static_cast<std::size_t>(ends[0])] = row_edge;
      cost += 1000000;
    } else {
      if (ends.empty()) --cost;
      while (ends.size() < 2) ends.push_back(nothing);
      if (!tie(state, ends[0], ends[1]) || !tie(state, ends[1], ends[0])) return;
    }
    const auto [place, is_new] = next.emplace(state, cost);
    if (!is_new) place->second = std::max(place->second, cost);
  }

  bool tie(State& state, int one, int two) const {
    if (one >= 0 && one < halves) state[static_cast<std::size_t>(one)] = two;
    if (one < first_port || two < first_port || one > two) return true;
    return allowed_.count({static_cast<std::size_t>(one - first_port), static_cast<std::size_t>(two - first_port)}) !=
           0;
  }

  Patch patch_;
  Bits ports_;
  Pairs allowed_;
};

}  // namespace naive
