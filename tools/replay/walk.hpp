// A random walk of splits, collapses and flips anywhere on a mesh. Each operation is checked around its vertices, and
// the whole mesh from time to time.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "replay/live_measure.hpp"
#include "replay/methods.hpp"
#include "restrip/mesh/strip_mesh.hpp"

namespace restrip::tools {

/// Starts the maintainer under test on a mesh, or on a copy whose buffer is measured. Tests supply faulty ones.
using BeginMaintainer = std::function<std::unique_ptr<Maintainer>(StripMesh&)>;

struct WalkOptions {
  std::uint64_t steps = 10'000;
  std::uint64_t seed = 1;
  std::uint64_t whole_check_every = 10'000;
  BufferOptions buffer{.operations_per_update = {}};
};

struct WalkReport {
  WalkOptions options;
  std::uint64_t splits = 0;
  std::uint64_t collapses = 0;
  std::uint64_t flips = 0;
  std::uint64_t refused = 0;          ///< steps whose operation was not possible
  std::uint64_t isolating = 0;        ///< splits and collapses that added isolated triangles anywhere in the mesh
  std::uint64_t flips_isolating = 0;  ///< flips that added isolated triangles
  std::size_t triangles = 0;          ///< at the end
  std::size_t strips = 0;
  std::size_t isolated = 0;
  std::vector<LiveBufferReport> live_buffers;  ///< at the start and at the end
  std::string fault;                           ///< empty if every check passed
  std::uint64_t fault_step = 0;                ///< where the fault was found

  [[nodiscard]] std::uint64_t operations() const noexcept { return splits + collapses + flips; }
};

/// Walks on `mesh`, whose colouring must be valid, and leaves it in its final state. The mesh keeps about its size.
/// Step i depends only on the seed, i and the mesh. If no fault is found, it walks again on copies to measure buffers.
[[nodiscard]] WalkReport walk(StripMesh& mesh, const WalkOptions& options, const BeginMaintainer& begin);

}  // namespace restrip::tools
