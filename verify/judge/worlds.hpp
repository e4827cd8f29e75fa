#pragma once
// Worlds: what solid edges may do outside the patch (docs/operation-file.md, "What a rule must be").

#include <array>
#include <compare>
#include <cstdint>
#include <string>
#include <vector>

#include "model/coloring.hpp"

namespace restrip::verify {

/// For each port the pair or block that it is in; blocks are numbered from 1 in the order of their first ports. 0 for
/// the ports that are connected to nothing.
struct World {
  std::array<std::uint8_t, most_ports> block_of{};
  friend auto operator<=>(const World&, const World&) = default;
};

/// All worlds of every set of solid ports.
class Worlds {
 public:
  Worlds(Constraint constraint, unsigned ports);

  /// In ascending order.
  const std::vector<World>& of(Mask ports) const { return worlds_[ports]; }

  /// For each world of `ports` the number of the world of `kept` that is left of it when the other ports are given up.
  /// Pairs of which one port is left are dropped: a node with one edge lies on no cycle.
  std::vector<std::uint32_t> restrictions(Mask ports, Mask kept) const;

  /// "ports 0-1 2-3 connected outside" or "no ports connected outside".
  std::string text_of(const World& world) const;

 private:
  void extend(World world, Mask ports, unsigned port, unsigned blocks);

  Constraint constraint_;
  unsigned ports_;
  std::vector<std::vector<World>> worlds_;
};

/// True when no solid cycle runs through the patch, whose solid inner edges are `inner`, and the world.
bool fits(const Side& side, const SolidGraph& inner, Mask ports, const World& world);

/// The pairs that a world of strips joins.
PortPairs pairs_of(const World& world);

/// Whether two pairings close a cycle when they are laid together: found by following them in turn, without a graph.
bool close_a_cycle(PortPairs one, PortPairs other, unsigned ports);

}  // namespace restrip::verify
