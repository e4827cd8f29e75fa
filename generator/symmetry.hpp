// The symmetries of a patch, found by nauty, named as certificates name them, and their action on masks.
#pragma once

#include <string>
#include <vector>

#include "coloring.hpp"
#include "patch.hpp"

namespace restrip::generator {

/// One symmetry: port i goes to (n + i) mod k for a turn, to (n - i) mod k for a mirror.
struct Symmetry {
  bool mirror = false;
  unsigned n = 0;
  std::vector<unsigned> port;    ///< where each port goes
  std::vector<unsigned> before;  ///< where each inner edge of the side before goes
  std::vector<unsigned> after;   ///< where each inner edge of the side after goes

  [[nodiscard]] std::string name() const;
};

/// All symmetries of the patch, identity first, then in ascending order of (mirror, n). Found as the automorphisms of
/// one coloured graph that holds both sides and the ports.
[[nodiscard]] std::vector<Symmetry> symmetries(const Patch& patch);

/// Moves bit i to bit to[i].
[[nodiscard]] Mask permute(Mask mask, const std::vector<unsigned>& to);

}  // namespace restrip::generator
