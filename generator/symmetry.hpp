// The symmetries of a patch, found by nauty, named as certificates name them, and their action on masks.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "coloring.hpp"
#include "patch.hpp"

namespace restrip::generator {

/// A patch taken to itself, each side to itself.
struct PatchMap {
  std::vector<unsigned> port;    ///< where each port goes
  std::vector<unsigned> before;  ///< where each inner edge of the side before goes
  std::vector<unsigned> after;   ///< where each inner edge of the side after goes
  std::vector<unsigned> nodes;   ///< where each node of the side after goes
};

/// All of them, found as the automorphisms of one coloured graph that holds both sides and the ports; in ascending
/// order of (port, before nodes, after nodes), so that the identity is first.
[[nodiscard]] std::vector<PatchMap> automorphisms(const Patch& patch);

/// One symmetry of a fan: port i goes to (n + i) mod k for a turn, to (n - i) mod k for a mirror.
struct Symmetry : PatchMap {
  bool mirror = false;
  unsigned n = 0;

  [[nodiscard]] std::string name() const;
};

/// All symmetries of the patch of a family, identity first, then in ascending order of (mirror, n).
[[nodiscard]] std::vector<Symmetry> symmetries(const Patch& patch);

/// Moves bit i to bit to[i].
[[nodiscard]] Mask permute(Mask mask, const std::vector<unsigned>& to);

[[nodiscard]] std::vector<unsigned> inverse(const std::vector<unsigned>& to);

/// Tells the smallest configuration of each orbit. Holds the images of all masks: 2^edges and 2^ports for each map.
class Smallest {
 public:
  template <class Map>
  Smallest(const Patch& patch, const std::vector<Map>& group) {
    for (const Map& map : group) {
      before_.push_back(images(patch.before.edges.size(), map.before));
      ports_.push_back(images(patch.before.owner.size(), map.port));
    }
  }

  /// Whether the configuration is the smallest (before, ports) of its orbit.
  [[nodiscard]] bool operator()(Mask before, Mask ports) const;
  [[nodiscard]] std::size_t orbits() const;

 private:
  [[nodiscard]] static std::vector<Mask> images(std::size_t bits, const std::vector<unsigned>& to);

  std::vector<std::vector<Mask>> before_;
  std::vector<std::vector<Mask>> ports_;
};

}  // namespace restrip::generator
