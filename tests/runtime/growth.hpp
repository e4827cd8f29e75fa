// Checks that work grows as promised from one size to twice the size.
#pragma once

#include <gtest/gtest.h>

#include "step_counter.hpp"

namespace restrip::counter {

inline ::testing::AssertionResult grows_at_most(double times, const Work& once, const Work& twice) {
  if (once.steps < 20) return ::testing::AssertionFailure() << "nothing was counted: " << once.steps << " steps";
  const double ratio = static_cast<double>(twice.steps) / static_cast<double>(once.steps);
  if (ratio <= times) return ::testing::AssertionSuccess() << once.steps << " steps, then " << twice.steps;
  return ::testing::AssertionFailure() << once.steps << " steps, then " << twice.steps << ": " << ratio << " times";
}
inline constexpr double linear = 2.4;  ///< n log n grows no faster
inline constexpr double constant = 1.25;

}  // namespace restrip::counter
