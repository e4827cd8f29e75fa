#pragma once
// Sets of numbers that are merged; each is known by its smallest member.

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace restrip::verify {

class MergedSets {
 public:
  explicit MergedSets(std::size_t size) : parent_(size) { std::iota(parent_.begin(), parent_.end(), 0U); }
  unsigned smallest(unsigned member) {
    while (parent_[member] != member) member = parent_[member] = parent_[parent_[member]];
    return member;
  }
  void merge(unsigned one, unsigned other) {
    const unsigned a = smallest(one);
    const unsigned b = smallest(other);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<unsigned> parent_;
};

}  // namespace restrip::verify
