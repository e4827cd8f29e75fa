// The cost: the criteria of an operation file, evaluated on the colours after the operation.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "model/coloring.hpp"

namespace restrip::verify {

/// The values of the criteria in order; compared lexicographically, smaller is better. Unused ones are 0.
using CostValues = std::array<std::int64_t, most_criteria>;

/// The cost of colours after the operation, if `given_up` ports were given up.
CostValues cost_of(const Operation& operation, Colors after, unsigned given_up);

/// "strips", "isolated + given_up", "-2 solid(1,3)".
std::string text_of(const Criterion& criterion);

}  // namespace restrip::verify
