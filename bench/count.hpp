// The quality of the strips of a mesh, for the counters of a benchmark.
#pragma once

#include <benchmark/benchmark.h>

#include "restrip/output/strips.hpp"

namespace restrip::bench {

inline void count_strips(benchmark::State& state, const StripMesh& mesh) {
  const Strips strips = extract_strips(mesh);
  const auto triangles = static_cast<double>(mesh.triangle_count());
  state.counters["triangles"] = triangles;
  state.counters["strips"] = static_cast<double>(strips.size());
  state.counters["indices_per_triangle"] = static_cast<double>(strip_index_count(mesh, strips)) / triangles;
}

}  // namespace restrip::bench
