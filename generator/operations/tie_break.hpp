// The tie-break, whose effect is measured, not proved: it keeps strips long over thousands of operations on fans
// (docs/reference/tables.md, "Tie-break").
#pragma once

#include "operations/description.hpp"

namespace restrip::generator {

/// What is known of strips outside the patch: nothing, or where they come back (linked rules). Each case has its own
/// weights.
enum class Sight { patch, outside };

/// The operation on which the rows of a position act (patch_of_rows), with its preference.
[[nodiscard]] Operation operation_of_rows(const Position& position, Sight sight);

/// The tie-break of a position with the side `after`: empty for descriptions of single operations and for descriptions
/// with an explicit constraint or cost.
[[nodiscard]] Criterion tie_break(const Position& position, const Side& after, Sight sight);

}  // namespace restrip::generator
