// What is measured, not proved: the tie-break that keeps strips long over thousands of operations on fans
// (docs/tables.md, "Tie-break").
#pragma once

#include "operations/description.hpp"

namespace restrip::generator {

/// What the strips of a patch are known to do outside it: nothing, or where they come back (linked rules). Each has its
/// own weights.
enum class Sight { patch, outside };

/// What rules are preferred for, where strips and isolated triangles leave a choice.
enum class Goal {
  strips,  ///< long strips after thousands of operations
  indices  ///< few swaps: two turns the same way in a row, each of which costs a plain strip one index
};

/// What the rows of a position act on (patch_of_rows), and what they are preferred for.
[[nodiscard]] Operation operation_of_rows(const Position& position, Sight sight, Goal goal);

/// The tie-break of a position where `after` is its side after: nothing for descriptions of single operations and for
/// those with a constraint or a cost of their own.
[[nodiscard]] Criterion tie_break(const Position& position, const Side& after, Sight sight, Goal goal);

}  // namespace restrip::generator
