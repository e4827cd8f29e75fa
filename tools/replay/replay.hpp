// Replays a progressive mesh from its base to its finest level and back, keeping the strips by one method
// (methods.hpp), and measures and checks it.
#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "lod/simplify.hpp"
#include "meshes/mend.hpp"
#include "meshes/soup.hpp"
#include "replay/live_measure.hpp"
#include "replay/methods.hpp"
#include "replay/walk.hpp"

namespace restrip::tools {

/// The mesh at one level of detail.
struct Level {
  std::size_t triangles = 0;
  std::size_t strips = 0;    ///< including isolated triangles
  std::size_t isolated = 0;  ///< strips of one triangle
  std::size_t swaps = 0;     ///< including a first turn that needs one more index
  std::size_t indices = 0;   ///< of an index buffer of strips with primitive restart
  /// The live buffer after all operations so far, including its gaps. 0: no live buffer.
  std::size_t buffer_indices = 0;
  double acmr = 0;     ///< of the live buffer, in a FIFO cache of 16 vertices
  double acmr_32 = 0;  ///< of 32
};

/// Counts the strips of a mesh. Adds a sentence to `faults` if a triangle is in no strip. Linear time.
[[nodiscard]] Level level_of(const StripMesh& mesh, std::vector<std::string>& faults);

/// The numbers of triangles of the levels to report, in geometric steps from the base up, without the finest level,
/// which follows the last split. `count` levels in all, at least 2.
[[nodiscard]] std::vector<std::size_t> level_sizes(std::size_t base_triangles, std::size_t fine_triangles,
                                                   std::size_t count);

struct ReplayOptions {
  std::size_t levels = 12;  ///< at which strips are counted, including base and finest level; at least 2
  std::size_t repeats = 5;  ///< of each timed run; 0: no timing
  std::size_t cycles = 0;   ///< down and up again after the first way up
  BufferOptions buffer{};
  std::string* trace = nullptr;  ///< receives a trace of the first way up and the way back (output/trace.hpp)
  /// Minimum number of timed operations: small meshes are repeated more often.
  std::size_t enough_operations = 200'000;
};

/// One pass down to the base and up again.
struct Cycle {
  std::size_t number = 0;  ///< from 1
  Level base;
  Level top;
  std::size_t isolating = 0;     ///< operations that introduced an isolated triangle
  std::size_t adding_strip = 0;  ///< operations that added a strip
};

inline constexpr std::size_t most_reported_cycles = 1024;

struct ReplayReport {
  std::size_t base_triangles = 0;
  std::size_t triangles = 0;  ///< at the finest level
  std::size_t operations = 0;
  std::size_t operations_without_rule = 0;  ///< refused: the file names an impossible split
  std::size_t operations_isolating = 0;     ///< introduced an isolated triangle
  std::size_t operations_adding_strip = 0;
  RuleCounts rules;                     ///< of the first way up and the way back
  std::vector<std::size_t> by_valence;  ///< [k]: splits of a fan of k triangles
  std::size_t most_strips = 0;          ///< over all levels on the first way up, after every split
  std::vector<Level> levels;            ///< on the way up
  std::vector<Level> levels_down;       ///< the same levels on the way back, coarsest first
  /// The last cycle and every n-th before it, from the first: n = 1, doubled whenever there are most_reported_cycles.
  std::vector<Cycle> cycles;
  /// Medians over the repeats. A split starts from vertices: both with and without strips, the time includes finding
  /// its spokes.
  double ns_per_operation = 0;
  double ns_per_operation_bare = 0;
  double ns_per_collapse = 0;
  double ns_per_collapse_bare = 0;
  /// Of the way up and down: the buffer at the base, at the finest level and at the base again. The levels show the
  /// first one.
  std::vector<LiveBufferReport> live_buffers;
  std::size_t levels_compared = 0;  ///< baked: levels reached again with the same strips
  std::vector<std::string> faults;  ///< found by a check; empty if all is well

  [[nodiscard]] bool valid() const noexcept { return faults.empty(); }
};

/// Starts at the base and replays every split. At the finest level, it checks the colouring from scratch,
/// decodes the index buffer, and compares the triangles with `original` (as a set of oriented triangles; if empty, with
/// a replay without rules). Baked strips go down and up again at least once, and every reported level must then have,
/// byte for byte, the same strips as before.
[[nodiscard]] ReplayReport replay(const PreparedMethod& prepared, const std::vector<Corners>& original,
                                  const ReplayOptions& options = {});

// ReplayReport as text and as JSON (docs/reference/programs.md, "The report of a replay").

/// The costs of baked strips.
struct BakedCosts {
  double flips_per_record = 0;
  double bytes_per_record = 0;  ///< of the file, vertex positions and connectivity included
  double seconds = 0;           ///< of baking; 0 if they were read from a file
};

/// What was replayed.
struct Subject {
  std::string name;
  std::size_t wanted_triangles = 0;  ///< of the base; 0 if the base was given
  LeftOut left_out;
  Mended mended;       ///< of the file, if it was read
  std::string policy;  ///< the method's name
  Search search;       ///< of the method
  Cost cost;           ///< the minimised cost
  std::optional<BakedCosts> baked;
};

[[nodiscard]] std::string as_text(const ReplayReport& report, const Subject& subject);
[[nodiscard]] std::string as_text(const WalkReport& walk);
[[nodiscard]] nlohmann::ordered_json as_json(const ReplayReport& report, const Subject& subject,
                                             const std::optional<WalkReport>& walk);

}  // namespace restrip::tools
