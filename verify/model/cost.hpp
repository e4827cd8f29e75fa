#pragma once
// What is best: the criteria of an operation file, counted on the colours after the operation.

#include <array>
#include <cstdint>
#include <string>

#include "model/coloring.hpp"

namespace restrip::verify {

/// The criteria in turn; compared as a whole, smaller is better. Those that the operation does not have are 0.
using CostValues = std::array<std::int64_t, most_criteria>;

/// The cost of colours after the operation, where so many ports were given up.
CostValues cost_of(const Operation& operation, Colors after, unsigned given_up);

/// "strips", "isolated + given_up", "-2 solid(1,3)".
std::string text_of(const Criterion& criterion);

}  // namespace restrip::verify
