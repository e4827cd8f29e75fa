// The best recolouring of a patch of whose outside only the pairs of ports are known that may be joined inside, found
// on the explicit graph: nodes are the triangles of the patch. Edges are decided one after the other; of all decisions
// that leave the same degrees and the same connected components at the nodes that still have edges to come, the best is
// kept. Independent of fans, arcs and pairs of neighbours.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <map>
#include <utility>
#include <vector>

#include "naive_patch.hpp"

namespace naive {

class OutsideFrontier {
 public:
  /// Nodes 0 … n - 1 are the triangles of the patch.
  explicit OutsideFrontier(int n) : n_(n), ports_(static_cast<std::size_t>(n)), edges_(static_cast<std::size_t>(n)) {}

  void add_edge(int u, int v) {
    const auto [low, high] = std::minmax(u, v);
    edges_[static_cast<std::size_t>(low)].push_back(high);
  }
  /// A solid port of which nothing is known. It may be joined inside only to those for which may_join(name, other).
  void add_hidden(int u, int name) { ports_[static_cast<std::size_t>(u)].push_back(name); }

  /// solid * 10^6 - isolated
  long best(const std::function<bool(int, int)>& may_join) const {
    may_join_ = &may_join;
    std::map<State, long> states{{State{}, 0}};
    const auto each_state = [&](const auto& step) {
      std::map<State, long> next;
      for (const auto& [state, value] : states) step(state, value, next);
      states.swap(next);
    };
    for (int u = 0; u < n_; ++u) {
      each_state([&](const State& state, long value, auto& next) { keep(next, with(state, u), value); });
      for (const int port : ports_[static_cast<std::size_t>(u)])
        each_state([&](State state, long value, auto& next) {
          if (++degree(state, u) > 2 || !give_name(state, component(state, u), port + 1)) return;
          keep(next, state, value);
        });
      for (const int v : edges_[static_cast<std::size_t>(u)])
        each_state([&](State state, long value, auto& next) {
          state = with(state, v);
          keep(next, state, value);
          if (++degree(state, u) > 2 || ++degree(state, v) > 2 || !unite(state, u, v)) return;
          keep(next, state, value + 1'000'000);
        });
      each_state([&](State state, long value, auto& next) {
        keep(next, without(state, u), value - (degree(state, u) == 0 ? 1 : 0));
      });
    }
    long result = -1;
    for (const auto& entry : states) result = std::max(result, entry.second);
    return result;
  }

 private:
  static constexpr int both = 1'000'000;

  /// Nodes with edges to come: number, degree, component, and the hidden port of the component (0: none).
  using Active = std::array<int, 4>;
  using State = std::vector<Active>;

  static auto find(State& state, int node) {
    return std::find_if(state.begin(), state.end(), [node](const Active& a) { return a[0] == node; });
  }
  static int& degree(State& state, int node) { return (*find(state, node))[1]; }
  static int component(State& state, int node) { return (*find(state, node))[2]; }

  static State with(State state, int node) {
    if (find(state, node) != state.end()) return state;
    int fresh = 0;
    for (const Active& a : state) fresh = std::max(fresh, a[2] + 1);
    state.push_back({node, 0, fresh, 0});
    return state;
  }
  static State without(State state, int node) {
    state.erase(find(state, node));
    return state;
  }
  bool give_name(State& state, int component, int name) const {
    int had = 0;
    for (const Active& a : state)
      if (a[2] == component) had = a[3];
    if (had == both || (had != 0 && !(*may_join_)(had - 1, name - 1))) return false;
    for (Active& a : state)
      if (a[2] == component) a[3] = had == 0 ? name : both;
    return true;
  }
  bool unite(State& state, int u, int v) const {
    const Active one = *find(state, u);
    const Active two = *find(state, v);
    if (one[2] == two[2]) return false;
    for (Active& a : state)
      if (a[2] == two[2]) {
        a[2] = one[2];
        a[3] = one[3];
      }
    return two[3] == 0 || (two[3] != both && give_name(state, one[2], two[3]));
  }
  /// In order of nodes, components numbered as they come.
  static void keep(std::map<State, long>& states, State state, long value) {
    std::sort(state.begin(), state.end());
    std::vector<int> names;
    for (Active& a : state) {
      const auto place = std::find(names.begin(), names.end(), a[2]);
      const auto number = static_cast<int>(place - names.begin());
      if (place == names.end()) names.push_back(a[2]);
      a[2] = number;
    }
    const auto [entry, fresh] = states.emplace(std::move(state), value);
    if (!fresh) entry->second = std::max(entry->second, value);
  }

  int n_;
  std::vector<std::vector<int>> ports_;
  std::vector<std::vector<int>> edges_;
  mutable const std::function<bool(int, int)>* may_join_ = nullptr;
};

/// The best recolouring for a key: of the outside only the pairs of ports joined before are known.
inline long best_for_key(const Patch& patch, const Bits& ports, const Bits& joined) {
  OutsideFrontier graph(static_cast<int>(patch.nodes));
  for (const auto& [u, v] : patch.edges) graph.add_edge(static_cast<int>(u), static_cast<int>(v));
  for (std::size_t p = 0; p < ports.size(); ++p)
    if (ports[p]) graph.add_hidden(static_cast<int>(patch.port_node[p]), static_cast<int>(p));
  const Pairs allowed = pairs_of(patch, ports, joined);
  return graph.best([&](int one, int other) {
    const auto [low, high] = std::minmax(one, other);
    return allowed.count({static_cast<std::size_t>(low), static_cast<std::size_t>(high)}) != 0;
  });
}

}  // namespace naive
