// Benchmarks that measure time themselves: each of their few iterations times many runs and reports the median.
#pragma once

#include <benchmark/benchmark.h>

#include <string>

#include "settings.hpp"

namespace restrip::bench {

/// Registers `run`, which takes a benchmark::State and sets the time of each iteration.
template <class Run>
void add_timed(const std::string& name, Run run, benchmark::IterationCount iterations = 3,
               benchmark::TimeUnit unit = benchmark::kMicrosecond) {
  benchmark::RegisterBenchmark(name.c_str(), run)
      ->UseManualTime()
      ->Unit(unit)
      ->Iterations(settings().quick ? 1 : iterations);
}

}  // namespace restrip::bench
