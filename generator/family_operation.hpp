// The families of docs/notation.md as operations: the criteria of docs/theory.md, section 4, of which two are proved
// and a third, the tie-break, is measured.
#pragma once

#include "operation.hpp"

namespace restrip::generator {

/// What the strips of a patch are known to do outside it: nothing, or where they come back (linked.hpp). Each has its
/// own weights.
enum class Sight { patch, outside };

/// What rules are preferred for, where strips and isolated triangles leave a choice.
enum class Goal {
  strips,  ///< long strips after thousands of operations
  indices  ///< few swaps: two turns the same way in a row, each of which costs a plain strip one index
};

/// What the rows of a position act on (patch_of_rows), and what they are preferred for.
[[nodiscard]] Operation operation_of(const Position& position, Sight sight, Goal goal);

}  // namespace restrip::generator
