#pragma once
// Orbits of configurations, counted twice: by Burnside's lemma over the turns and mirrors that docs/notation.md names,
// and by nauty, which knows nothing of turns and mirrors and compares coloured graphs.

#include <cstdint>
#include <vector>

#include "operation.hpp"

namespace restrip::verify {

struct OrbitCounts {
  std::uint64_t all = 0;
  std::uint64_t valid = 0;
  friend bool operator==(const OrbitCounts&, const OrbitCounts&) = default;
};

/// `valid` says of each configuration, by concatenated(inner, ports), whether it is valid.
OrbitCounts burnside_orbits(const Operation& operation, const std::vector<bool>& valid);

/// The number of different canonical forms. Where the bare operation has no symmetry but the trivial one (nauty says
/// so too), every configuration is an orbit of its own and none needs a canonical form.
OrbitCounts nauty_orbits(const Operation& operation, const std::vector<bool>& valid);

}  // namespace restrip::verify
