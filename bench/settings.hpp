// Shared by all benchmark programs: the size of a run, and main().
#pragma once

#include <filesystem>

namespace restrip::bench {

struct Settings {
  bool quick = false;            ///< RESTRIP_BENCH_QUICK is set: only small made meshes; takes seconds
  std::filesystem::path meshes;  ///< RESTRIP_MESHES: the folder of bunny.obj and dragon_vrip.ply; empty if not set
};
[[nodiscard]] const Settings& settings();

/// Every program registers its benchmarks here; main() is in settings.cpp.
void register_benchmarks();

}  // namespace restrip::bench
