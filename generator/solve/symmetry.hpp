// The symmetries of an operation, found by nauty, and their action on masks.
#pragma once

#include <vector>

#include "describe/operation.hpp"

namespace restrip::generator {

/// A map of an operation to itself that preserves each side.
struct PatchMap {
  std::vector<unsigned> port;    ///< the image of each port
  std::vector<unsigned> before;  ///< the image of each inner edge of the side before
  std::vector<unsigned> after;   ///< the image of each inner edge of the side after
};

/// Applies `first`, then `second`.
[[nodiscard]] PatchMap then(const PatchMap& first, const PatchMap& second);

/// The automorphisms of the patch that preserve the ports that may be given up and the preference; they need not
/// preserve the tie-break.
struct Symmetries {
  /// All of them if they are few: turns of the ports first, if the operation asks for it, the rest in ascending order,
  /// the identity first. Otherwise the generators.
  std::vector<PatchMap> maps;
  std::vector<PatchMap> generators;
  double order = 1;  ///< the order of the group
};
[[nodiscard]] Symmetries symmetries(const Operation& operation);

/// Moves bit i to bit to[i].
[[nodiscard]] Mask permute(Mask mask, const std::vector<unsigned>& to);

[[nodiscard]] std::vector<unsigned> inverse(const std::vector<unsigned>& to);

/// The orbits of all configurations of a patch: a bit for each configuration, (before << number of ports | ports), set
/// unless it is the smallest of its orbit.
[[nodiscard]] std::vector<bool> larger_in_orbits(const Patch& patch, const std::vector<PatchMap>& maps);

}  // namespace restrip::generator
