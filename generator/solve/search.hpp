// Exhaustive search: the best sound recolouring for every key.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "describe/operation.hpp"
#include "solve/coloring.hpp"

namespace restrip::generator {

/// The colours after an operation.
struct Choice {
  Mask recoloring = 0;
  Mask kept = 0;          ///< ports that stay solid
  unsigned solid = 0;     ///< solid inner edges
  unsigned isolated = 0;  ///< isolated triangles; a port given up counts as one
};

/// By solid ports: the pairs that some valid recolouring joins. For other pairs it does not matter whether they were
/// joined.
[[nodiscard]] std::vector<PortPairs> relevant_pairs(const Operation& operation);

/// The values of the criteria, followed by the tie-break; smaller is better, compared lexicographically.
using CriterionValues = std::array<std::int64_t, most_criteria + 1>;

/// A valid recolouring.
struct Candidate : Choice {
  PortPairs joins;
  CriterionValues values{};
};

/// The valid recolourings of one port mask, best first. `colorings` are the legal colourings of the side after the
/// operation. The best for a key is the first that joins only previously joined pairs. Fans always have one: everything
/// dashed inside, and no port given up.
[[nodiscard]] std::vector<Candidate> candidates_for(const Operation& operation, const std::vector<Coloring>& colorings,
                                                    Mask ports);

}  // namespace restrip::generator
