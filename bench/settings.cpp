#include "settings.hpp"

#include <benchmark/benchmark.h>

#include <cstdlib>

namespace restrip::bench {

const Settings& settings() {
  static const Settings given = [] {
    Settings s;
    s.quick = std::getenv("RESTRIP_BENCH_QUICK") != nullptr;
    if (const char* folder = std::getenv("RESTRIP_MESHES"); folder != nullptr && !s.quick) s.meshes = folder;
    return s;
  }();
  return given;
}

}  // namespace restrip::bench

int main(int count, char** values) {
  benchmark::Initialize(&count, values);
  if (benchmark::ReportUnrecognizedArguments(count, values)) return 1;
  restrip::bench::register_benchmarks();
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}
