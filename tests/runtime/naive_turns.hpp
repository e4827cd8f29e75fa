// Patches with the corners of their triangles, straight from docs/reference/notation.md, and the cost of a colouring by
// its definition: a strip passes a triangle about the corner that its two edges there share, and a solid edge is a swap
// when the strip passes both of its triangles about the same corner. Shares no code with the runtime.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "naive_patch.hpp"

namespace naive {

using Corner = int;
using Edge = std::array<Corner, 2>;
inline constexpr Corner no_corner = -1;

struct Weights {
  int restart = 3;
  int swap = 1;
  int isolated = 0;
};

// What is behind each port: the corner about which the strip continues there. Only of solid ports.
using Behind = std::vector<Corner>;

struct TurnPatch {
  Patch graph;
  std::vector<std::array<Corner, 3>> triangles;  // by node
  std::vector<Edge> ports;

  Edge shared(std::size_t u, std::size_t v) const {
    std::vector<Corner> both;
    for (const Corner x : triangles[u]) {
      if (std::count(triangles[v].begin(), triangles[v].end(), x) != 0) both.push_back(x);
    }
    return {both.at(0), both.at(1)};
  }
  Edge inner(std::size_t e) const { return shared(graph.edges[e].first, graph.edges[e].second); }
};

inline Corner common(const Edge& one, const Edge& other) {
  return one[0] == other[0] || one[0] == other[1] ? one[0] : one[1];
}

// Corners: 0 and 1 the two ends of the new mesh edge, or 0 the hub; 2 + i the i-th corner of the rim. Triangles with
// `one` <= number < `other` are at corner 1.
inline TurnPatch with_corners(Patch graph, std::size_t k, std::size_t one, std::size_t other,
                              const std::vector<std::size_t>& gaps_of_inserted) {
  TurnPatch patch;
  patch.graph = std::move(graph);
  patch.triangles.resize(patch.graph.nodes, {no_corner, no_corner, no_corner});
  const auto rim = [&](std::size_t i) { return static_cast<Corner>(2 + (patch.graph.cyclic ? i % k : i)); };
  for (std::size_t i = 0; i < k; ++i) {
    patch.ports.push_back({rim(i), rim(i + 1)});
    patch.triangles[patch.graph.port_node[i]] = {one <= i && i < other ? 1 : 0, rim(i), rim(i + 1)};
  }
  std::size_t next = 0;
  for (auto& triangle : patch.triangles) {
    if (triangle[0] == no_corner) triangle = {0, 1, rim(gaps_of_inserted.at(next++))};
  }
  return patch;
}

inline TurnPatch turning_split(std::size_t k, std::size_t a) {
  return with_corners(ring_with_chord(k, a), k, 0, a, {0, a});
}
inline TurnPatch turning_collapse(std::size_t k) { return with_corners(closed_fan(k), k, 0, 0, {}); }
inline TurnPatch turning_open_split(std::size_t k, std::size_t i, std::size_t j) {
  return with_corners(path_with_chord(k, i, j), k, i, j, {i, j});
}
inline TurnPatch turning_boundary_split(std::size_t k, std::size_t i) { return with_corners(path(k, i), k, i, k, {i}); }
inline TurnPatch turning_fan_collapse(std::size_t k) { return with_corners(open_fan(k), k, 0, 0, {}); }

// What a colouring with legal degrees costs but for swaps at ports, and the corner about which the strip over each
// solid port passes the port's triangle.
struct Turned {
  int cost = 0;
  std::vector<Corner> at_port;

  // With what is behind the ports.
  int with(const Behind& behind, const Weights& weights) const {
    int all = cost;
    for (std::size_t i = 0; i < at_port.size(); ++i) {
      all += at_port[i] != no_corner && at_port[i] == behind[i] ? weights.swap : 0;
    }
    return all;
  }
};

inline Turned turned(const TurnPatch& patch, const Bits& inner, const Bits& ports, const Weights& weights) {
  std::vector<std::vector<Edge>> passed(patch.graph.nodes);
  Turned result;
  result.cost = weights.restart * static_cast<int>(patch.graph.nodes);
  for (std::size_t e = 0; e < patch.graph.edges.size(); ++e) {
    if (!inner[e]) continue;
    result.cost -= weights.restart;
    passed[patch.graph.edges[e].first].push_back(patch.inner(e));
    passed[patch.graph.edges[e].second].push_back(patch.inner(e));
  }
  for (std::size_t i = 0; i < ports.size(); ++i) {
    if (ports[i]) passed[patch.graph.port_node[i]].push_back(patch.ports[i]);
  }
  const auto corner = [&](std::size_t node) {
    return passed[node].size() < 2 ? no_corner : common(passed[node][0], passed[node][1]);
  };
  for (std::size_t e = 0; e < patch.graph.edges.size(); ++e) {
    const Corner here = corner(patch.graph.edges[e].first);
    if (inner[e] && here != no_corner && here == corner(patch.graph.edges[e].second)) result.cost += weights.swap;
  }
  for (std::size_t i = 0; i < ports.size(); ++i) {
    result.at_port.push_back(ports[i] ? corner(patch.graph.port_node[i]) : no_corner);
  }
  for (const auto& edges : passed) result.cost += edges.empty() ? weights.isolated : 0;
  return result;
}

}  // namespace naive
