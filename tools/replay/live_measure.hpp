// LiveMeasure: what an index buffer costs that is kept in step with a mesh: the bytes that updates write, its length
// next to the strips that it draws, and its misses in a vertex cache.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "restrip/mesh/strip_mesh.hpp"
#include "restrip/output/live_buffer.hpp"
#include "restrip/output/strips.hpp"

namespace restrip::tools {

struct BufferOptions {
  StripForm form = StripForm::restart;                     ///< or a list, for comparison
  std::vector<std::size_t> operations_per_update{1, 100};  ///< one run for each
};

/// The buffer at one moment.
struct BufferState {
  std::string at;
  std::size_t triangles = 0;
  std::size_t strip_indices = 0;  ///< of the strips from scratch, without cuts and gaps
  std::size_t indices = 0;
  double fifo_16 = 0;  ///< misses a triangle in a first-in-first-out cache
  double fifo_32 = 0;
};

struct LiveBufferReport {
  std::size_t operations_per_update = 0;
  double bytes_per_operation = 0;  ///< written by updates
  /// An update after that many operations: a timed run with the buffer minus one without. 0: not timed.
  double ns_per_update = 0;
  double ns_per_update_with_history = 0;  ///< the same when it also ends a frame of a History
  std::vector<BufferState> states;
};

/// Watches a mesh, which must outlive it, from its beginning to its end.
class LiveMeasure {
 public:
  /// `most_triangles`: that the mesh will have, so that the buffer on the device is never outgrown.
  LiveMeasure(StripMesh& mesh, const BufferOptions& options, std::size_t operations_per_update,
              std::size_t most_triangles);
  ~LiveMeasure() { mesh_.watch(nullptr); }
  LiveMeasure(const LiveMeasure&) = delete;
  LiveMeasure& operator=(const LiveMeasure&) = delete;

  /// To be called after each operation.
  void count_operation();
  /// Brings the buffer in step with the mesh. Its state becomes a part of the report if `at` is not empty. Adds a
  /// sentence to `faults` if the buffer does not draw the mesh.
  BufferState look(const std::string& at, std::vector<std::string>& faults);
  [[nodiscard]] LiveBufferReport report() const;

 private:
  std::size_t update();

  StripMesh& mesh_;
  BufferOptions options_;
  LiveBuffer buffer_;
  std::vector<Triangle> changed_;
  std::size_t operations_ = 0;
  std::size_t written_ = 0;  // indices, by updates
  LiveBufferReport report_;
};

}  // namespace restrip::tools
