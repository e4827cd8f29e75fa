// Counts orbits of configurations by merging each with its images under the symmetries found here. The generator counts
// them by nauty's symmetries.
#pragma once

#include <cstdint>
#include <vector>

#include "judge/symmetry.hpp"

namespace restrip::verify {

struct OrbitCounts {
  std::uint64_t all = 0;
  std::uint64_t valid = 0;
};

/// `valid` gives for each configuration, indexed by concatenated(inner, ports), whether it is valid.
OrbitCounts merged_orbits(const Operation& operation, const Symmetries& symmetries, const std::vector<bool>& valid);

}  // namespace restrip::verify
