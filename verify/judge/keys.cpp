#include "judge/keys.hpp"

namespace restrip::verify {

Keys::Keys(const Operation& operation) : operation_(operation), joinable_(mask_count(operation.ports())) {
  std::vector<PortPairs> joined(joinable_.size());  // by kept ports
  for_each_valid(operation.after, most_solid(operation.constraint), [&](Colors after, const SolidGraph& inner) {
    joined[after.ports].add(joined_ports(operation.after, inner, after.ports));
  });
  for (Mask ports = 0; ports < joinable_.size(); ++ports)
    for (Mask kept = 0; kept <= ports; ++kept)
      if (admissible(operation, ports, kept)) joinable_[ports].add(joined[kept]);
}

std::optional<Key> Keys::key_of(Colors configuration) const {
  const std::optional<SolidGraph> inner =
      valid_graph(operation_.before, configuration, most_solid(operation_.constraint));
  if (!inner) return {};
  const PortPairs joined = joined_ports(operation_.before, *inner, configuration.ports);
  return Key{configuration.ports, joined.both(joinable_[configuration.ports])};
}

bool Keys::sound(const Key& key, Colors recoloring) const {
  const std::optional<SolidGraph> inner = valid_graph(operation_.after, recoloring, most_solid(operation_.constraint));
  return inner && joined_ports(operation_.after, *inner, recoloring.ports).within(key.joined);
}

}  // namespace restrip::verify
