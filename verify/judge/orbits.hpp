#pragma once
// Orbits of configurations, counted twice: by merging each with its images under the symmetries that are found here,
// and by nauty, which knows nothing of these and compares coloured graphs.

#include <cstdint>
#include <optional>
#include <vector>

#include "judge/symmetry.hpp"

namespace restrip::verify {

struct OrbitCounts {
  std::uint64_t all = 0;
  std::uint64_t valid = 0;
  friend bool operator==(const OrbitCounts&, const OrbitCounts&) = default;
};

/// `valid` says of each configuration, by concatenated(inner, ports), whether it is valid.
OrbitCounts merged_orbits(const Operation& operation, const Symmetries& symmetries, const std::vector<bool>& valid);

/// The number of different canonical forms. Where the bare operation has no symmetry but the trivial one (nauty says
/// so too), every configuration is an orbit of its own and none needs a canonical form. nullopt where a graph would
/// have to know more: of costs that count some members only, or of more nodes than it has room for.
std::optional<OrbitCounts> nauty_orbits(const Operation& operation, const std::vector<bool>& valid);

}  // namespace restrip::verify
