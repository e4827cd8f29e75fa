// The best recolouring by looking at all of them, for every key of one patch.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "naive_patch.hpp"

namespace naive {

using Mask = std::uint64_t;

// One colouring of the patch that is valid as far as the inner edges go, with what the ports must be asked.
struct Coloring {
  Mask inner = 0;
  Mask full = 0;    // fan triangles with two solid inner edges: no solid port there
  Mask single = 0;  // fan triangles with none: isolated unless the port is solid
  int solid = 0;
  int isolated = 0;                                       // inserted triangles without a solid edge
  std::vector<std::pair<std::size_t, std::size_t>> ends;  // fan triangles at the two ends of one strand
};

class ExhaustiveSearch {
 public:
  explicit ExhaustiveSearch(const Patch& patch) : patch_(patch), index_(std::size_t{1} << patch.edges.size(), npos) {
    for (Mask inner = 0; inner < index_.size(); ++inner) {
      if (const std::optional<Coloring> coloring = coloring_of(inner)) {
        index_[inner] = colorings_.size();
        colorings_.push_back(*coloring);
      }
    }
  }

  // After this, best(joined) answers for every canonical `joined` of these ports.
  void solve(Mask ports) {
    const std::size_t k = patch_.port_node.size();
    const Bits port_bits = bits_of(ports, k);
    before_.assign(k, k);
    for (std::size_t i = 0; i < k; ++i) {
      if (port_bits[i]) before_[i] = port_before(patch_, port_bits, i);
    }
    ports_ = ports;
    best_.assign(std::size_t{1} << k, std::numeric_limits<long>::min());
    for (const Coloring& coloring : colorings_)
      if (const std::optional<Mask> needed = needs(coloring))
        best_[*needed] = std::max(best_[*needed], value(coloring));
    // A key with more pairs allows everything that a key with fewer pairs allows.
    for (Mask joined = 0; joined < best_.size(); ++joined) {
      for (std::size_t i = 0; i < k; ++i) {
        if (((joined >> i) & 1) != 0) best_[joined] = std::max(best_[joined], best_[joined & ~(Mask{1} << i)]);
      }
    }
  }

  long best(Mask joined) const { return best_[joined]; }

  // The canonical key of colours before an operation under the solved ports, if they are valid: the pairs of neighbours
  // that they join. No recolouring of a fan joins other ports.
  std::optional<Mask> key(Mask inner) const {
    if (inner >= index_.size() || index_[inner] == npos) return std::nullopt;
    const Coloring& coloring = colorings_[index_[inner]];
    if ((coloring.full & ports_) != 0) return std::nullopt;
    Mask joined = 0;
    for (const auto& [i, j] : coloring.ends) {
      if (((ports_ >> i) & (ports_ >> j) & 1) == 0) continue;
      if (before_[i] == j) joined |= Mask{1} << i;
      if (before_[j] == i) joined |= Mask{1} << j;
    }
    return joined;
  }

  // The value of a recolouring under the solved ports, if it is sound for this key.
  std::optional<long> judge(Mask inner, Mask joined) const {
    if (inner >= index_.size() || index_[inner] == npos) return std::nullopt;
    const Coloring& coloring = colorings_[index_[inner]];
    const std::optional<Mask> needed = needs(coloring);
    if (!needed || (*needed & ~joined) != 0) return std::nullopt;
    return value(coloring);
  }

 private:
  static constexpr std::size_t npos = static_cast<std::size_t>(-1);

  std::optional<Coloring> coloring_of(Mask inner) const {
    Coloring result;
    result.inner = inner;
    UnionFind strands(patch_.nodes);
    std::vector<int> degree(patch_.nodes, 0);
    for (std::size_t e = 0; e < patch_.edges.size(); ++e) {
      if (((inner >> e) & 1) == 0) continue;
      const auto [u, v] = patch_.edges[e];
      ++result.solid;
      if (++degree[u] > 2 || ++degree[v] > 2 || !strands.unite(u, v)) return std::nullopt;
    }
    result.isolated = static_cast<int>(std::count(degree.begin(), degree.end(), 0));
    for (std::size_t i = 0; i < patch_.port_node.size(); ++i) {
      const std::size_t u = patch_.port_node[i];
      if (degree[u] == 2) result.full |= Mask{1} << i;
      if (degree[u] == 0) {
        result.single |= Mask{1} << i;
        --result.isolated;
      }
      for (std::size_t j = i + 1; j < patch_.port_node.size() && degree[u] == 1; ++j) {
        const std::size_t v = patch_.port_node[j];
        if (degree[v] == 1 && strands.find(u) == strands.find(v)) result.ends.emplace_back(i, j);
      }
    }
    return result;
  }

  long value(const Coloring& coloring) const {
    return coloring.solid * 1'000'000L - coloring.isolated - std::popcount(coloring.single & ~ports_);
  }

  // The canonical key that allows exactly what the colouring joins, or nothing when no key allows it.
  std::optional<Mask> needs(const Coloring& coloring) const {
    if ((coloring.full & ports_) != 0) return std::nullopt;
    Mask needed = 0;
    for (const auto& [i, j] : coloring.ends) {
      if (((ports_ >> i) & (ports_ >> j) & 1) == 0) continue;
      if (before_[i] != j && before_[j] != i) return std::nullopt;
      if (before_[i] == j) needed |= Mask{1} << i;
      if (before_[j] == i) needed |= Mask{1} << j;
    }
    return needed;
  }

  Patch patch_;
  std::vector<Coloring> colorings_;
  std::vector<std::size_t> index_;
  Mask ports_ = 0;
  std::vector<std::size_t> before_;
  std::vector<long> best_;
};

}  // namespace naive
