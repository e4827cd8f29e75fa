// Patches as graphs, straight from docs/reference/notation.md: lists of nodes and edges, union-find, and nothing
// clever. The oracle of the tests in this folder; it shares no code with the runtime.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

namespace naive {

using Bits = std::vector<bool>;
using Pairs = std::set<std::pair<std::size_t, std::size_t>>;  // smaller port first

struct Patch {
  std::size_t nodes = 0;
  std::vector<std::pair<std::size_t, std::size_t>> edges;  // by index of the inner edge
  std::vector<std::size_t> port_node;
  bool cyclic = false;  // does "the port before" go round?
};

// Nodes 0 ... n-1 in a row, or in a ring; `inserted` nodes lack ports.
inline Patch row(std::size_t n, bool ring, const std::vector<std::size_t>& inserted) {
  Patch patch;
  patch.nodes = n;
  patch.cyclic = ring;
  for (std::size_t m = 0; m + 1 < n; ++m) patch.edges.emplace_back(m, m + 1);
  if (ring) patch.edges.emplace_back(n - 1, 0);
  for (std::size_t m = 0; m < n; ++m) {
    if (std::find(inserted.begin(), inserted.end(), m) == inserted.end()) patch.port_node.push_back(m);
  }
  if (inserted.size() == 2) patch.edges.emplace_back(inserted[0], inserted[1]);
  return patch;
}

inline Patch closed_fan(std::size_t k) { return row(k, true, {}); }
inline Patch open_fan(std::size_t k) { return row(k, false, {}); }
inline Patch ring_with_chord(std::size_t k, std::size_t a) { return row(k + 2, true, {0, a + 1}); }
inline Patch path_with_chord(std::size_t k, std::size_t i, std::size_t j) { return row(k + 2, false, {i, j + 1}); }
inline Patch path(std::size_t k, std::size_t i) { return row(k + 1, false, {i}); }

class UnionFind {
 public:
  explicit UnionFind(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), std::size_t{0}); }
  std::size_t find(std::size_t x) const {
    while (parent_[x] != x) x = parent_[x];
    return x;
  }
  bool unite(std::size_t x, std::size_t y) {
    x = find(x);
    y = find(y);
    if (x == y) return false;
    parent_[y] = x;
    return true;
  }

 private:
  std::vector<std::size_t> parent_;
};

struct Analysis {
  bool valid = false;
  int solid = 0;
  int isolated = 0;
  Pairs joined;  // the pairing P; only when valid
  long value() const { return solid * 1'000'000L - isolated; }
};

inline Analysis analyze(const Patch& patch, const Bits& inner, const Bits& ports) {
  Analysis result;
  UnionFind strands(patch.nodes);
  std::vector<int> degree(patch.nodes, 0);
  for (std::size_t e = 0; e < patch.edges.size(); ++e) {
    if (!inner[e]) continue;
    const auto [u, v] = patch.edges[e];
    ++result.solid;
    ++degree[u];
    ++degree[v];
    if (!strands.unite(u, v)) return result;
  }
  for (std::size_t i = 0; i < patch.port_node.size(); ++i) degree[patch.port_node[i]] += ports[i] ? 1 : 0;
  for (const int d : degree) {
    if (d > 2) return result;
    result.isolated += d == 0 ? 1 : 0;
  }
  result.valid = true;
  std::vector<std::vector<std::size_t>> reached(patch.nodes);
  for (std::size_t i = 0; i < patch.port_node.size(); ++i) {
    if (ports[i]) reached[strands.find(patch.port_node[i])].push_back(i);
  }
  for (const auto& ends : reached) {
    for (std::size_t x = 0; x < ends.size(); ++x) {
      for (std::size_t y = x + 1; y < ends.size(); ++y) result.joined.emplace(ends[x], ends[y]);
    }
  }
  return result;
}

// The solid port before port i, or k if it does not exist.
inline std::size_t port_before(const Patch& patch, const Bits& ports, std::size_t i) {
  const std::size_t k = patch.port_node.size();
  for (std::size_t step = 1; step < k; ++step) {
    if (step > i && !patch.cyclic) break;
    const std::size_t j = (i + k - step) % k;
    if (ports[j]) return j;
  }
  return k;
}

// `joined` of the key, in its canonical form, from a pairing.
inline Bits key_of(const Patch& patch, const Bits& ports, const Pairs& pairing) {
  const std::size_t k = patch.port_node.size();
  Bits joined(k, false);
  for (std::size_t i = 0; i < k; ++i) {
    if (!ports[i]) continue;
    const std::size_t j = port_before(patch, ports, i);
    joined[i] = j != k && pairing.count({j < i ? j : i, j < i ? i : j}) != 0;
  }
  return joined;
}

// The pairs a key stands for; the inverse of key_of on pairs of consecutive ports.
inline Pairs pairs_of(const Patch& patch, const Bits& ports, const Bits& joined) {
  const std::size_t k = patch.port_node.size();
  Pairs pairs;
  for (std::size_t i = 0; i < k; ++i) {
    if (!ports[i] || !joined[i]) continue;
    const std::size_t j = port_before(patch, ports, i);
    if (j != k) pairs.emplace(j < i ? j : i, j < i ? i : j);
  }
  return pairs;
}

inline bool subset(const Pairs& inner, const Pairs& outer) {
  return std::includes(outer.begin(), outer.end(), inner.begin(), inner.end());
}

inline Bits bits_of(std::uint64_t mask, std::size_t n) {
  Bits bits(n);
  for (std::size_t i = 0; i < n; ++i) bits[i] = ((mask >> i) & 1) != 0;
  return bits;
}

inline std::uint64_t mask_of(const Bits& bits) {
  std::uint64_t mask = 0;
  for (std::size_t i = 0; i < bits.size(); ++i) mask |= std::uint64_t{bits[i]} << i;
  return mask;
}

// Bit strings in words, as the runtime takes them; bits after the end are noise that must not matter.
inline std::vector<std::uint64_t> words_of(const Bits& bits) {
  std::vector<std::uint64_t> words(bits.size() / 64 + 1, ~std::uint64_t{0});
  for (std::size_t i = 0; i < bits.size(); ++i) {
    if (!bits[i]) words[i / 64] &= ~(std::uint64_t{1} << (i % 64));
  }
  return words;
}

inline Bits bits_from(const std::vector<std::uint64_t>& words, std::size_t n) {
  Bits bits(n);
  for (std::size_t i = 0; i < n; ++i) bits[i] = ((words[i / 64] >> (i % 64)) & 1) != 0;
  return bits;
}

}  // namespace naive
