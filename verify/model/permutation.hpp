#pragma once
// Permutations of ports, and what they do to masks and keys.

#include <vector>

#include "model/key.hpp"

namespace restrip::verify {

using Permutation = std::vector<unsigned>;  ///< where each goes

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
