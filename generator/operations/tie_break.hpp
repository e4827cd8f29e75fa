// What is measured, not proved: the tie-break that keeps strips long over thousands of operations on fans
// (docs/reference/tables.md, "Tie-break").
#pragma once

#include "operations/description.hpp"

namespace restrip::generator {

/// What the strips of a patch are known to do outside it: nothing, or where they come back (linked rules). Each has its
/// own weights.
enum class Sight { patch, outside };

/// What the rows of a position act on (patch_of_rows), and what they are preferred for.
[[nodiscard]] Operation operation_of_rows(const Position& position, Sight sight);

/// The tie-break of a position where `after` is its side after: nothing for descriptions of single operations and for
/// those with a constraint or a cost of their own.
[[nodiscard]] Criterion tie_break(const Position& position, const Side& after, Sight sight);

}  // namespace restrip::generator
