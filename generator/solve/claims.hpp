// What certificates claim of the configurations of one operation; the words are those of docs/certificate.md.
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

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

/// One number for several positions: counts add up, worst cases are the worst.
[[nodiscard]] inline Claims sum(const std::vector<Claims>& parts) {
  Claims total = parts.at(0);
  for (std::size_t i = 1; i < parts.size(); ++i) {
    const Claims& part = parts[i];
    total.configurations += part.configurations;
    total.valid += part.valid;
    total.orbits += part.orbits;
    total.valid_orbits += part.valid_orbits;
    total.costing += part.costing;
    total.worst_strips = std::max(total.worst_strips, part.worst_strips);
    total.worst_isolated = std::max(total.worst_isolated, part.worst_isolated);
  }
  return total;
}

}  // namespace restrip::generator
