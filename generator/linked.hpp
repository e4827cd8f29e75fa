// Linked rules: what to do when it is known which strips come back from outside the patch (docs/theory.md, section 7).
//
// Knowing more of the outside makes more recolourings sound, never fewer, and a recolouring that joins fewer ports is
// sound wherever one that joins them and more is. So one list for each position and port mask serves every outside:
// the recolourings that no other beats with a part of its pairs, best first. The first one that is sound is optimal.
#pragma once

#include <string>
#include <vector>

#include "coloring.hpp"
#include "family_operation.hpp"
#include "patch.hpp"

namespace restrip::generator {

/// A recolouring and the ports that it joins.
struct Alternative {
  Mask recoloring = 0;
  unsigned solid = 0;       ///< solid inner edges
  unsigned isolated = 0;    ///< isolated triangles
  std::vector<Mask> pairs;  ///< two bits each, ascending
};

/// The lists of one position; of a valence for collapses, whose fan does not know where the triangles were.
struct LinkedSection {
  Position position;
  std::vector<std::vector<Alternative>> lists;  ///< by port mask
  Goal goal = Goal::strips;
};

/// Every section of a family in ascending order of position, as yet without lists, for valences up to max_k <= 13.
[[nodiscard]] std::vector<LinkedSection> linked_sections_of(const Family& family, unsigned max_k);

/// Finds the lists. Threads may solve different sections at the same time.
void solve(LinkedSection& section);

}  // namespace restrip::generator
