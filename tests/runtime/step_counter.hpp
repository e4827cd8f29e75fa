// Counts the steps and the allocations of a program, for promises of complexity. A step is a basic block that runs:
// files compiled with -fsanitize-coverage=trace-pc call step_counter.cpp in each. So no loop can be forgotten, loops of
// the standard library's templates included, and no clock is read.
#pragma once

#include <cstdint>

namespace restrip::counter {

std::uint64_t steps() noexcept;
std::uint64_t allocations() noexcept;

/// What `run` took.
struct Work {
  std::uint64_t steps = 0;
  std::uint64_t allocations = 0;
};
template <class Run>
Work work_of(Run&& run) {
  const Work before{steps(), allocations()};
  run();
  return {steps() - before.steps, allocations() - before.allocations};
}

}  // namespace restrip::counter
