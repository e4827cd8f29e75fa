// What certificates claim of the configurations of one operation; the words are those of docs/certificate.md.
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>

namespace restrip::generator {

struct Claims {
  std::size_t configurations = 0;
  std::size_t valid = 0;
  std::size_t orbits = 0;
  std::size_t valid_orbits = 0;
  std::size_t costing = 0;
  int worst_strips = std::numeric_limits<int>::min();
  int worst_isolated = std::numeric_limits<int>::min();

  /// One valid configuration: what its rule changes, whether that counts as costing, and whether the configuration is
  /// the smallest of its orbit.
  void count(int strips, int isolated, bool costs, bool smallest) {
    ++valid;
    valid_orbits += smallest ? 1U : 0U;
    costing += costs ? 1U : 0U;
    worst_strips = std::max(worst_strips, strips);
    worst_isolated = std::max(worst_isolated, isolated);
  }
};

}  // namespace restrip::generator
