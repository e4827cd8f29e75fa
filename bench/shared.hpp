// Shared by all benchmark programs: main() and the size of a run; the progressive meshes that they replay; and players,
// which play such a mesh up and down by one method (replay/methods.hpp). Some benchmarks measure time
// themselves: each of their few iterations times many runs and reports the median.
#pragma once

#include <benchmark/benchmark.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "lod/progressive_mesh.hpp"
#include "replay/methods.hpp"
#include "restrip/mesh/strip_mesh.hpp"

namespace restrip::bench {

using tools::Method;
using tools::method_named;

struct Settings {
  bool quick = false;            ///< RESTRIP_BENCH_QUICK is set: only small made meshes; takes seconds
  std::filesystem::path meshes;  ///< RESTRIP_MESHES: the folder of bunny.obj and dragon_vrip.ply; empty if not set
};
[[nodiscard]] const Settings& settings();

/// Every program registers its benchmarks here; main() is in shared.cpp.
void register_benchmarks();

struct Subject {
  tools::ProgressiveMesh mesh;  ///< quadric collapses to 2 %
  std::size_t triangles = 0;    ///< of the finest level
};

/// "made", and "bunny" and "dragon" if their files exist.
[[nodiscard]] std::vector<std::string> subject_names();
/// Made on first use, and kept.
[[nodiscard]] const Subject& subject(const std::string& name);

/// Baking the dragon takes minutes (docs/how-to/baked-strips.md has its figures), so it is left out here.
[[nodiscard]] bool is_measured(const std::string& name, const Method& method);
/// Under the default cost of the method. Made on first use, and kept.
[[nodiscard]] const tools::PreparedMethod& prepared(const std::string& name, const Method& method);

/// Plays a progressive mesh up and down by one method. A split starts from vertices: finding its spokes is part of it.
class Player {
 public:
  Player(const std::string& name, const Method& method);

  [[nodiscard]] const StripMesh& mesh() const noexcept { return mesh_; }
  [[nodiscard]] StripMesh& mesh() noexcept { return mesh_; }
  /// The first record after which the mesh has at least this share of its finest triangles.
  [[nodiscard]] std::size_t level_of(double share) const;

  void up_to(std::size_t level);
  void down_to(std::size_t level);
  /// Starts again from a copy of the mesh taken at that level. Linear time.
  void restart(const StripMesh& mesh, std::size_t level);
  void restart();

 private:
  const Subject* subject_;
  const tools::PreparedMethod* prepared_;
  std::size_t level_ = 0;  // the number of records played so far
  StripMesh mesh_;
  std::unique_ptr<tools::Maintainer> maintainer_;
};

/// The triangles of one level as a list: the input for making strips, or an order, from scratch.
struct LevelList {
  std::vector<std::uint32_t> indices;  ///< three a triangle; vertices are numbered by appearance
  std::size_t vertices = 0;
  StripMesh mesh;  ///< the same triangles
};

/// The list of the level with `percent` of the finest triangles. Made on first use, and kept.
[[nodiscard]] const LevelList& level_list(const std::string& name, int percent);

/// Mesh edges to be collapsed, by their vertices, and their chords at first. Their patches do not overlap: they can be
/// done in any order, and undone, without any simplification.
struct Sites {
  std::vector<tools::Record> records;
  std::vector<StripMesh::Halfedge> chords;

  [[nodiscard]] std::size_t size() const noexcept { return records.size(); }
};
/// Up to `count` disjoint legal collapses of interior edges, at random places in random order.
[[nodiscard]] Sites spread_out_sites(const StripMesh& mesh, std::size_t count);
/// Adjacent sites, from the first triangle on: a part of the mesh that is being edited.
[[nodiscard]] Sites neighboring_sites(const StripMesh& mesh, std::size_t count);

/// Registers `run`, which takes a benchmark::State and sets the time of each iteration.
template <class Run>
void add_timed(const std::string& name, Run run) {
  benchmark::RegisterBenchmark(name.c_str(), run)
      ->UseManualTime()
      ->Unit(benchmark::kMicrosecond)
      ->Iterations(settings().quick ? 1 : 3);
}

}  // namespace restrip::bench
