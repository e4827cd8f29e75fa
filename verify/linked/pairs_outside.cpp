#include "linked/pairs_outside.hpp"

#include <optional>

namespace restrip::verify {
namespace {

std::optional<unsigned> partner(PortPairs pairs, unsigned port, unsigned ports) {
  for (unsigned other = 0; other < ports; ++other)
    if (other != port && pairs.has(port, other)) return other;
  return {};
}

}  // namespace

PortPairs pairs_of(const World& world) {
  PortPairs pairs;
  for (unsigned j = 1; j < most_ports; ++j)
    for (unsigned i = 0; i < j; ++i)
      if (world.block_of[i] != 0 && world.block_of[i] == world.block_of[j]) pairs.add(i, j);
  return pairs;
}

bool close_a_cycle(PortPairs one, PortPairs other, unsigned ports) {
  for (unsigned start = 0; start < ports; ++start)
    for (std::optional<unsigned> at = start; at;) {
      at = partner(one, *at, ports);
      if (at) at = partner(other, *at, ports);
      if (at == start) return true;
    }
  return false;
}

}  // namespace restrip::verify
