#include "key.hpp"

#include "mutants.hpp"

namespace restrip::verify {
namespace {

/// The nearest solid port in descending order of number; cyclic in a closed fan.
std::optional<unsigned> preceding_solid_port(unsigned port, Mask ports, unsigned port_count, bool closed) {
  for (unsigned step = 1; step < port_count; ++step) {
    if (!closed && step > port) break;
    const unsigned candidate = (port + port_count - step) % port_count;
    if (is_solid(ports, candidate)) return candidate;
  }
  return {};
}

}  // namespace

Mask joined_to_predecessor(PortPairs joined, Mask ports, unsigned port_count, bool closed) {
  Mask mask = 0;
  for (unsigned port = 0; port < port_count; ++port) {
    if (!is_solid(ports, port)) continue;
    const std::optional<unsigned> preceding = preceding_solid_port(port, ports, port_count, closed);
    if (!preceding || !joined.has(*preceding, port)) continue;
    mask |= single(mutated(Mutant::swapped_port_joined) ? *preceding : port);
  }
  return mask;
}

std::optional<PortPairs> pairs_of(Mask joined, Mask ports, unsigned port_count, bool closed) {
  PortPairs pairs;
  for (unsigned port = 0; port < port_count; ++port) {
    if (!is_solid(joined, port)) continue;
    const std::optional<unsigned> preceding = preceding_solid_port(port, ports, port_count, closed);
    if (!is_solid(ports, port) || !preceding) return {};
    pairs.add(*preceding, port);
  }
  return pairs;
}

Key key_of(const Operation& operation, Coloring before, const Survey& survey) {
  if (operation.keyed_by_inner) return {before.ports, before.inner};
  const Patch& patch = operation.before;
  return {before.ports, joined_to_predecessor(survey.joined, before.ports, patch.ports(), patch.closed())};
}

}  // namespace restrip::verify
