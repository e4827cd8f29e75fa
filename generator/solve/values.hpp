// How good a recolouring is, by the criteria of its operation.
#pragma once

#include <array>
#include <cstdint>

#include "operations/operation.hpp"
#include "solve/coloring.hpp"

namespace restrip::generator {

/// What the criteria add up to, and last the tie-break; smaller is better, compared in turn.
using CriterionValues = std::array<std::int64_t, most_criteria + 1>;

/// CriterionValues of a coloring after the operation whose ports `kept` are solid, out of the ports that were. Depends
/// on the patch alone, never on the machine.
[[nodiscard]] CriterionValues values_of(const Operation& operation, const Coloring& coloring, const Outcome& outcome,
                                        Mask ports, Mask kept);

}  // namespace restrip::generator
