// Disjoint sets with path halving (Tarjan and van Leeuwen 1984).
#pragma once

#include <cstdint>
#include <numeric>
#include <vector>

namespace restrip::tools {

class DisjointSets {
 public:
  explicit DisjointSets(std::size_t size) : parent_(size) { std::iota(parent_.begin(), parent_.end(), 0U); }

  [[nodiscard]] std::uint32_t find(std::uint32_t x) {
    while (parent_[x] != x) x = parent_[x] = parent_[parent_[x]];
    return x;
  }
  /// False if they were in the same set already.
  bool unite(std::uint32_t x, std::uint32_t y) {
    x = find(x);
    y = find(y);
    // The smaller index becomes the root: no randomness, no ranks.
    if (x < y) parent_[y] = x;
    if (y < x) parent_[x] = y;
    return x != y;
  }

 private:
  std::vector<std::uint32_t> parent_;
};

}  // namespace restrip::tools
