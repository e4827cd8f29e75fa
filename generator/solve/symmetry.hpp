// The symmetries of an operation, found by nauty, and their action on masks.
#pragma once

#include <cstddef>
#include <vector>

#include "operations/operation.hpp"

namespace restrip::generator {

/// An operation taken to itself, each side to itself.
struct PatchMap {
  std::vector<unsigned> port;    ///< where each port goes
  std::vector<unsigned> before;  ///< where each inner edge of the side before goes
  std::vector<unsigned> after;   ///< where each inner edge of the side after goes
};

/// First `first`, then `second`.
[[nodiscard]] PatchMap then(const PatchMap& first, const PatchMap& second);

/// The automorphisms of the patch under which what may be given up and the preference stay what they are; the tie-break
/// need not.
struct Symmetries {
  /// All of them where they are few: those that turn the ports first, where the operation wants that, the rest in
  /// ascending order, the identity first. Otherwise the generators.
  std::vector<PatchMap> maps;
  std::vector<PatchMap> generators;
  double order = 1;  ///< how many there are
};
[[nodiscard]] Symmetries symmetries(const Operation& operation);

/// Moves bit i to bit to[i].
[[nodiscard]] Mask permute(Mask mask, const std::vector<unsigned>& to);

[[nodiscard]] std::vector<unsigned> inverse(const std::vector<unsigned>& to);

/// The orbits of all configurations of a patch, each marked but for its smallest (before, ports): a bit for each.
class Orbits {
 public:
  Orbits(const Patch& patch, const std::vector<PatchMap>& maps);

  [[nodiscard]] bool is_smallest(Mask before, Mask ports) const {
    return !other_[std::size_t{before} << ports_ | ports];
  }
  [[nodiscard]] std::size_t count() const { return count_; }

 private:
  std::size_t ports_;
  std::vector<bool> other_;
  std::size_t count_ = 0;
};

}  // namespace restrip::generator
