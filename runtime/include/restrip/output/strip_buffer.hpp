// StripBuffer: an index buffer that is kept in step with a mesh, rewriting only what changed.
//
// A renderer that draws strips while the level of detail moves does not want to write its whole index buffer again
// after every few operations. Here the strips are drawn as *runs*, consecutive triangles of one strip, each in a place
// of its own in the buffer; when triangles change, the runs they are in are written again, and nothing else.
//
//   std::vector<Triangle> changed;
//   mesh.watch(&changed);
//   StripBuffer buffer(mesh);                        // upload buffer.indices()
//   ... operations ...
//   for (const auto& range : buffer.update(mesh, changed)) upload(range);
//   changed.clear();
//
// Draw the whole buffer as one triangle strip with primitive restart (strips.hpp). Between runs, and in
// unused places, there are restart indices, which draw nothing. A run is at most `max_run` triangles long: a
// longer strip is written as several runs, at two or three indices more for each, so that a change costs no more than
// the runs around it, however long the strip.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "restrip/mesh/strip_mesh.hpp"
#include "restrip/output/strips.hpp"

namespace restrip {

class StripBuffer {
 public:
  /// Some consecutive indices of the buffer.
  struct Range {
    std::size_t first = 0;
    std::size_t count = 0;
    friend constexpr bool operator==(const Range&, const Range&) = default;
  };

  /// Writes the strips of a valid colouring. Linear time. Where `max_run` is less than 2, 2 is taken.
  explicit StripBuffer(const StripMesh& mesh, std::uint32_t max_run = 64) : max_run_(std::max(max_run, 2U)) {
    rebuild(mesh);
  }

  /// Writes everything anew, without unused places.
  void rebuild(const StripMesh& mesh);

  /// Brings the buffer in step with the mesh. `changed` names every triangle that has changed since the last call, as
  /// StripMesh::watch does; removed ones and repetitions do no harm. Returns the ranges whose indices may have changed,
  /// ascending and apart from each other; the buffer may have grown, and now and then it is rebuilt as a whole, when
  /// more of it is unused than used. Valid until the next call. Time: that of the runs rewritten.
  std::span<const Range> update(const StripMesh& mesh, std::span<const Triangle> changed);

  [[nodiscard]] std::span<const std::uint32_t> indices() const noexcept { return indices_; }
  /// Number of runs.
  [[nodiscard]] std::size_t runs() const noexcept { return runs_.size() - free_runs_.size(); }
  /// Indices that draw runs, the restart index behind each included; the rest of the buffer is unused.
  [[nodiscard]] std::size_t used() const noexcept { return used_; }

 private:
  struct Run {
    std::size_t first = 0;
    std::uint32_t room = 0;       // indices; a multiple of room_step
    std::uint32_t used = 0;       // indices, the restart index included
    std::uint32_t triangles = 0;  // 0: there is no such run
  };
  static constexpr std::uint32_t room_step = 8;

  [[nodiscard]] bool has_run(Triangle t) const noexcept {
    return t < run_of_.size() && run_of_[t] != none && runs_[run_of_[t]].triangles != 0;
  }
  void release(std::uint32_t run);
  void give_back(std::size_t first, std::uint32_t room);
  void collect(const StripMesh& mesh, Triangle start);
  void write(const StripMesh& mesh, std::span<const Triangle> triangles);
  std::size_t place_for(std::uint32_t room);
  void merge_ranges();

  std::uint32_t max_run_;
  std::vector<std::uint32_t> indices_;
  std::vector<Run> runs_;
  std::vector<std::uint32_t> free_runs_;
  std::vector<std::uint32_t> run_of_;            // by triangle
  std::vector<std::vector<std::size_t>> empty_;  // by room / room_step: where unused places start
  std::size_t used_ = 0;
  // Of the current update.
  std::vector<Triangle> stretch_;
  std::vector<std::uint32_t> text_;
  std::vector<std::uint32_t> released_;
  std::vector<Range> written_;
};

}  // namespace restrip

#include "restrip/output/impl/strip_buffer.hpp"
