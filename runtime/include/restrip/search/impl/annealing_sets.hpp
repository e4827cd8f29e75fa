// Two sets of an annealing: strips as trees, which find whether triangles are in one strip in logarithmic time; and a
// sparse set of numbers, visited in order. Included by annealing.hpp.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
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

/// Numbers below a bound as bits, 64 to a word, and above the words a bit for each that is not empty, and so on: the
/// next word with a number is found in O(log(bound)) steps, however many empty words lie between.
class MarkedWords {
 public:
  static constexpr std::size_t no_word = (std::numeric_limits<std::size_t>::max)();

  /// Empties the set.
  void reset(std::size_t bound) {
    levels_.clear();
    for (std::size_t words = (bound + 63) / 64; words != 0; words = words == 1 ? 0 : (words + 63) / 64)
      levels_.emplace_back(words, 0);
  }
  [[nodiscard]] bool empty() const noexcept { return levels_.empty(); }

  /// The numbers 64 * word … 64 * word + 63.
  [[nodiscard]] std::uint64_t operator[](std::size_t word) const noexcept { return levels_[0][word]; }
  void mark(std::size_t number) noexcept {
    for (auto& level : levels_) {
      std::uint64_t& word = level[number / 64];
      const bool was_empty = word == 0;
      word |= std::uint64_t{1} << number % 64;
      if (!was_empty) return;
      number /= 64;
    }
  }
  void clear(std::size_t number) noexcept {
    for (auto& level : levels_) {
      std::uint64_t& word = level[number / 64];
      word &= ~(std::uint64_t{1} << number % 64);
      if (word != 0) return;
      number /= 64;
    }
  }
  /// The first word from `word` on that is not empty, or no_word.
  [[nodiscard]] std::size_t next(std::size_t word) const noexcept {
    if (levels_.empty()) return no_word;
    if (word < levels_[0].size() && levels_[0][word] != 0) return word;
    std::size_t level = 1;
    for (; level < levels_.size(); ++level, word = word / 64 + 1) {
      if (word / 64 >= levels_[level].size()) return no_word;
      const std::uint64_t left = levels_[level][word / 64] >> word % 64;
      if (left == 0) continue;
      word += static_cast<unsigned>(std::countr_zero(left));
      break;
    }
    if (level == levels_.size()) return no_word;
    for (; level-- > 1;) word = word * 64 + static_cast<unsigned>(std::countr_zero(levels_[level][word]));
    return word;
  }

 private:
  std::vector<std::vector<std::uint64_t>> levels_;
};

}  // namespace restrip::detail
