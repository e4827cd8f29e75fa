// Counts the steps and the allocations of a program, for promises of complexity. A step is a basic block that runs:
// files compiled with -fsanitize-coverage=trace-pc call step_counter.cpp in each. So no loop can be forgotten, loops of
// the standard library's templates included, and no clock is read.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>

#include "../support/failing_new.hpp"

namespace restrip::counter {

std::uint64_t steps() noexcept;

/// What `run` took.
struct Work {
  std::uint64_t steps = 0;
  std::uint64_t allocations = 0;
};
template <class Run>
Work work_of(Run&& run) {
  const Work before{steps(), testing_support::allocations()};
  run();
  return {steps() - before.steps, testing_support::allocations() - before.allocations};
}

/// Whether work grows as promised from one size to twice the size.
inline ::testing::AssertionResult grows_at_most(double times, const Work& once, const Work& twice) {
  if (once.steps < 20) return ::testing::AssertionFailure() << "nothing was counted: " << once.steps << " steps";
  const double ratio = static_cast<double>(twice.steps) / static_cast<double>(once.steps);
  if (ratio <= times) return ::testing::AssertionSuccess() << once.steps << " steps, then " << twice.steps;
  return ::testing::AssertionFailure() << once.steps << " steps, then " << twice.steps << ": " << ratio << " times";
}
inline constexpr double linear = 2.4;  ///< n log n grows no faster
inline constexpr double constant = 1.25;

}  // namespace restrip::counter
