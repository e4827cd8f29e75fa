#pragma once
// What strips outside join, as pairs of ports.

#include "judge/worlds.hpp"

namespace restrip::verify {

/// Of a world of strips.
PortPairs pairs_of(const World& world);

/// Whether two pairings close a cycle when they are laid together: found by following them in turn, without a graph.
bool close_a_cycle(PortPairs one, PortPairs other, unsigned ports);

}  // namespace restrip::verify
