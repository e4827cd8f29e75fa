// Which sound recolouring is the rule (docs/theory.md section 4): two criteria that are proved, and a tie-break that is
// measured.
#pragma once

#include <cstdint>

#include "coloring.hpp"
#include "patch.hpp"

namespace restrip::generator {

/// What the strips of a patch are known to do outside it: nothing, or where they come back (linked.hpp). Each has its
/// own weights.
enum class Sight { patch, outside };

/// What rules are preferred for, where strips and isolated triangles leave a choice.
enum class Goal {
  strips,  ///< long strips after thousands of operations
  indices  ///< few swaps: two turns the same way in a row, each of which costs a plain strip one index
};

/// The third criterion: a number, smaller is better, for recolourings that are equal in solid edges and isolated
/// triangles. Depends on the patch alone, never on the machine. Chosen by replaying real meshes (docs/tables.md says
/// how).
[[nodiscard]] std::int64_t tie_break(const Position& position, const Side& after, const Coloring& coloring,
                                     const Outcome& outcome, Mask ports, Sight sight, Goal goal);

}  // namespace restrip::generator
