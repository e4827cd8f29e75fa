// The tie-break, whose effect is measured, not proved: it keeps strips long over thousands of operations on fans
// (docs/reference/tables.md, "Tie-break").
#pragma once

#include "describe/description.hpp"

namespace restrip::generator {

/// The operation on which the rows of a position act (patch_of_rows), with its preference.
[[nodiscard]] Operation operation_of_rows(const Position& position);

/// The tie-break of a position with the side `after`: empty for descriptions of single operations and for descriptions
/// with an explicit constraint or cost.
[[nodiscard]] Criterion tie_break(const Position& position, const Side& after);

}  // namespace restrip::generator
