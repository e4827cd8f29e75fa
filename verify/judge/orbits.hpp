#pragma once
// Counts orbits of configurations in two ways: by merging each with its images under the symmetries found here, and by
// nauty, which compares coloured graphs independently.

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

/// `valid` gives for each configuration, indexed by concatenated(inner, ports), whether it is valid.
OrbitCounts merged_orbits(const Operation& operation, const Symmetries& symmetries, const std::vector<bool>& valid);

/// The number of different canonical forms. If the bare operation has only the trivial symmetry (also according to
/// nauty), every configuration is a separate orbit and no canonical form is needed. nullopt if the graph cannot express
/// the operation: a cost that counts some members only, or too many nodes.
std::optional<OrbitCounts> nauty_orbits(const Operation& operation, const std::vector<bool>& valid);

}  // namespace restrip::verify
