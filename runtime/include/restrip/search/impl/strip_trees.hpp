// Finds whether triangles are in one strip, in logarithmic time. Included by annealing.hpp.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "restrip/mesh/strip_mesh.hpp"

namespace restrip::detail {

/// The strips of a colouring, each as a splay tree in the order of its triangles; a bit turns a whole tree
/// around (Sleator, Tarjan, "Self-adjusting binary search trees", 1985). Each function except reset() takes amortised
/// O(log n) steps. 13 bytes a triangle.
class StripTrees {
 public:
  /// Begins again with a tree for each of N triangles.
  void reset(std::size_t triangles) {
    nodes_.assign(triangles, {});
    turned_.assign(triangles, 0);
  }

  /// Joins two different strips, which end at a and at b.
  void link(Triangle a, Triangle b) noexcept {
    splay(a);
    splay(b);
    if (nodes_[a].child[1] != none) turn(a);
    if (nodes_[b].child[0] != none) turn(b);
    push_down(a);
    push_down(b);
    nodes_[b].child[0] = a;
    nodes_[a].parent = b;
  }
  /// Cuts a strip between a and b, which follow each other.
  void cut(Triangle a, Triangle b) noexcept {
    splay(a);
    splay(b);
    Triangle below = a;  // the child of b on a's side, a few steps above
    while (nodes_[below].parent != b) below = nodes_[below].parent;
    nodes_[below].parent = none;
    nodes_[b].child[nodes_[b].child[1] == below ? 1 : 0] = none;
  }
  [[nodiscard]] bool together(Triangle a, Triangle b) noexcept {
    splay(a);
    splay(b);
    return a == b || nodes_[a].parent != none;
  }

 private:
  struct Node {
    Triangle parent = none;
    std::array<Triangle, 2> child{none, none};
  };

  void turn(Triangle t) noexcept { turned_[t] ^= 1U; }
  void push_down(Triangle t) noexcept {
    if (turned_[t] == 0) return;
    turned_[t] = 0;
    std::swap(nodes_[t].child[0], nodes_[t].child[1]);
    for (const Triangle child : nodes_[t].child)
      if (child != none) turn(child);
  }
  [[nodiscard]] unsigned side_of(Triangle t) const noexcept { return nodes_[nodes_[t].parent].child[1] == t ? 1 : 0; }
  // Lifts t above its parent. Neither is turned.
  void rotate(Triangle t) noexcept {
    const Triangle parent = nodes_[t].parent;
    const Triangle above = nodes_[parent].parent;
    const unsigned side = side_of(t);
    if (above != none) nodes_[above].child[side_of(parent)] = t;
    const Triangle inner = nodes_[t].child[1 - side];
    nodes_[parent].child[side] = inner;
    if (inner != none) nodes_[inner].parent = parent;
    nodes_[t].child[1 - side] = parent;
    nodes_[parent].parent = t;
    nodes_[t].parent = above;
  }
  // Makes t the root of its tree. A root is never turned.
  void splay(Triangle t) noexcept {
    while (nodes_[t].parent != none) {
      const Triangle parent = nodes_[t].parent;
      const Triangle above = nodes_[parent].parent;
      if (above != none) push_down(above);
      push_down(parent);
      push_down(t);
      if (above != none) rotate(side_of(t) == side_of(parent) ? parent : t);
      rotate(t);
    }
  }

  std::vector<Node> nodes_;
  std::vector<std::uint8_t> turned_;
};

}  // namespace restrip::detail
