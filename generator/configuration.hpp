// The two-colored configurations of a patch before an operation: all 2^(2k) of a split, and likewise for the other
// families.
#pragma once

#include <compare>
#include <cstddef>
#include <vector>

#include "coloring.hpp"
#include "patch.hpp"

namespace restrip::generator {

/// What a rule needs to know of the colours before (docs/notation.md). Where a family is keyed by its inner edges
/// `joined` is their colours.
struct Key {
  Mask ports = 0;
  Mask joined = 0;
  friend auto operator<=>(const Key&, const Key&) = default;
};

/// One valid configuration.
struct Configuration {
  Mask before = 0;
  Mask ports = 0;
  Key key;
  unsigned solid = 0;     ///< solid inner edges
  unsigned isolated = 0;  ///< isolated triangles
};

/// Calls visit for every valid configuration of the position, in ascending order of (before, ports).
template <class Visit>
void for_each_valid(const Position& position, const Side& before, Visit&& visit) {
  const auto ports_end = Mask{1} << before.owner.size();
  for (const Coloring& coloring : legal_colorings(before)) {
    for (Mask ports = 0; ports < ports_end; ++ports) {
      const auto outcome = with_ports(coloring, ports);
      if (!outcome) continue;
      const Mask joined = position.family->keyed_by_inner
                              ? coloring.inner
                              : joined_to_previous(outcome->pairs, ports, position.k, closed(*position.family));
      visit(Configuration{coloring.inner, ports, {ports, joined}, outcome->solid, outcome->isolated});
    }
  }
}

}  // namespace restrip::generator
