// Benchmarks that measure time themselves: each of their few iterations times many runs and reports the median. And
// counters for the quality of the strips.
#pragma once

#include <benchmark/benchmark.h>

#include <string>

#include "restrip/output/strips.hpp"
#include "settings.hpp"

namespace restrip::bench {

/// Registers `run`, which takes a benchmark::State and sets the time of each iteration.
template <class Run>
void add_timed(const std::string& name, Run run) {
  benchmark::RegisterBenchmark(name.c_str(), run)
      ->UseManualTime()
      ->Unit(benchmark::kMicrosecond)
      ->Iterations(settings().quick ? 1 : 3);
}

inline void count_strips(benchmark::State& state, std::size_t triangles, std::size_t strips, std::size_t indices) {
  state.counters["triangles"] = static_cast<double>(triangles);
  state.counters["strips"] = static_cast<double>(strips);
  state.counters["indices_per_triangle"] = static_cast<double>(indices) / static_cast<double>(triangles);
}
inline void count_strips(benchmark::State& state, const StripMesh& mesh) {
  const Strips strips = extract_strips(mesh);
  count_strips(state, mesh.triangle_count(), strips.size(), strip_index_count(mesh, strips));
}

}  // namespace restrip::bench
