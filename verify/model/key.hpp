// The key of a configuration (docs/reference/operation-file.md, "What a rule must be"): what a rule needs to know; and
// permutations of ports, which move keys.
#pragma once

#include <vector>

#include "model/masks.hpp"

namespace restrip::verify {

struct Key {
  Mask ports = 0;    ///< the solid ports
  PortPairs joined;  ///< pairs of them that are joined and that some recolouring joins
  friend constexpr bool operator==(Key, Key) = default;
  friend constexpr auto operator<=>(Key, Key) = default;
};

using Permutation = std::vector<unsigned>;  ///< destinations

inline Mask moved(Mask mask, const Permutation& permutation) {
  Mask result = 0;
  for (unsigned i = 0; i < permutation.size(); ++i)
    if (is_solid(mask, i)) result |= single(permutation[i]);
  return result;
}

inline Key moved(Key key, const Permutation& ports) {
  Key result{moved(key.ports, ports), {}};
  for (unsigned j = 1; j < ports.size(); ++j)
    for (unsigned i = 0; i < j; ++i)
      if (key.joined.has(i, j)) result.joined.add(ports[i], ports[j]);
  return result;
}

}  // namespace restrip::verify
