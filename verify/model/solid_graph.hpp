#pragma once
// Solid edges as a graph that grows edge by edge, and tells when an edge closes a cycle. Its nodes are the triangles of
// a side and, behind them, what connects ports outside.

#include <array>
#include <cstdint>

#include "model/side.hpp"

namespace restrip::verify {

class SolidGraph {
 public:
  SolidGraph() {
    for (std::size_t i = 0; i < parent_.size(); ++i) parent_[i] = static_cast<std::uint8_t>(i);
  }

  /// False when the edge closes a cycle.
  bool join(unsigned one, unsigned other) {
    const unsigned a = root(one);
    const unsigned b = root(other);
    if (a == b) return false;
    parent_[a] = static_cast<std::uint8_t>(b);
    return true;
  }
  bool connected(unsigned one, unsigned other) const { return root(one) == root(other); }
  /// One node that stands for all that are connected with this one.
  unsigned root(unsigned node) const {
    while (parent_[node] != node) node = parent_[node];
    return node;
  }

  static constexpr unsigned outside(unsigned block) { return most_triangles + block; }

 private:
  std::array<std::uint8_t, most_triangles + most_ports> parent_{};
};

}  // namespace restrip::verify
