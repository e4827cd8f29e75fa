// The forms of index buffers for hardware and engines: StripFormat describes one, format_strips() writes it.
//
//   const IndexBuffer buffer = format_strips(strip_indices(mesh), {.form = StripForm::stitched});
//   upload(buffer.bytes());                    // 2 or 4 bytes an index: buffer.index_bytes()
//   for (const IndexRange& batch : buffer.batches) draw(buffer.form, batch);
//
// strips_of() (search/strips_of.hpp), the live buffers (output/live_buffer.hpp, live_mesh.hpp), the programs (--form,
// --index), the C interface and JavaScript take the same description.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <variant>
#include <vector>

#include "restrip/precondition.hpp"

namespace restrip {

enum class StripForm : std::uint8_t {
  restart,   ///< one triangle strip; the index with all bits set lies between two strips (primitive restart)
  stitched,  ///< one triangle strip without restart: repeated indices lead from strip to strip. For hardware and
             ///< formats without restart. Two indices for each strip but the first, instead of one
  lengths,   ///< the strips one after the other, and a table of their lengths: one draw call each, or a multi-draw
  list,      ///< a triangle list, three indices a triangle
};

enum class IndexWidth : std::uint8_t {
  automatic,  ///< 16 bits where every index is below 65,535, else 32
  bits16,
  bits32,
};

struct StripFormat {
  StripForm form = StripForm::restart;
  IndexWidth width = IndexWidth::automatic;
  /// Return a list instead if it has fewer indices, as with many isolated triangles; IndexBuffer::form says so.
  bool list_if_shorter = true;
  /// At most this many different vertices and this many indices in a batch, at least 3 and 4; 0: no limit. Strips are
  /// cut where a batch ends; indices still count the vertices of the whole mesh. A live buffer has no batches; draw a
  /// stitched live buffer in windows (live_buffer.hpp).
  std::size_t most_vertices = 0;
  std::size_t most_indices = 0;
  friend constexpr bool operator==(const StripFormat&, const StripFormat&) = default;
};

/// Some consecutive indices of a buffer.
struct IndexRange {
  std::size_t first = 0;
  std::size_t count = 0;
  friend constexpr bool operator==(const IndexRange&, const IndexRange&) = default;
};

/// How a live buffer of strips stays short, and in an order that a vertex cache likes.
struct LayoutOptions {
  /// Vertices of the first-in-first-out cache that runs of strips are ordered for, up to 64; 0: no order.
  unsigned cache = 32;
  /// The length that cuts and gaps may add, per mille of the indices needed, up to 1,000,000. Above it,
  /// updates close gaps.
  unsigned waste = 95;
  /// Indices that an update may move to close gaps, for each index of the runs that it rewrites, up to 100. To put new
  /// runs next to their neighbours it may move half as many, and 30 for each unit.
  unsigned work = 5;
  [[nodiscard]] constexpr bool in_range() const noexcept { return cache <= 64 && waste <= 1'000'000 && work <= 100; }
  friend constexpr bool operator==(const LayoutOptions&, const LayoutOptions&) = default;
};

/// Which ranges an update of a live buffer returns.
struct RangeOptions {
  /// Ranges at most this many indices apart are joined: fewer uploads, with a few more indices.
  std::size_t merge_gap = 2;
  /// Ranges begin and end at multiples of this many bytes, 2 or a multiple of 4; the last may end with the buffer,
  /// whose length is a multiple of 4 bytes. WebGPU's writeBuffer needs 4.
  std::size_t align = 4;
};

/// The result of an update of a live buffer: the ranges to upload, ascending and disjoint.
struct Upload : std::span<const IndexRange> {
  /// The buffer has become longer than room() was, or its indices wider: make a new buffer of room() indices on the
  /// device. The only range is then the whole buffer.
  bool outgrown = false;
};

/// The highest vertex number with 16-bit indices: 0xFFFF restarts strips, or is forbidden as in glTF.
inline constexpr std::uint32_t highest_index16 = 0xFFFE;

struct IndexBuffer {
  StripForm form = StripForm::restart;  ///< as in the format, or StripForm::list when that is shorter
  std::variant<std::vector<std::uint32_t>, std::vector<std::uint16_t>> indices;
  std::vector<std::uint32_t> lengths;  ///< of each strip, for StripForm::lengths
  std::vector<IndexRange> batches;     ///< to be drawn one by one: consecutive, without the restarts between; strips
                                       ///< start again in each. One for the whole buffer if nothing limits it
  std::size_t triangles = 0;           ///< drawn, degenerate ones left out
  std::size_t strips = 0;              ///< before batches cut them

  [[nodiscard]] std::size_t size() const noexcept {
    return std::visit([](const auto& all) { return all.size(); }, indices);
  }
  [[nodiscard]] bool empty() const noexcept { return size() == 0; }
  /// 2 or 4.
  [[nodiscard]] std::size_t index_bytes() const noexcept { return indices.index() == 0 ? 4 : 2; }
  /// In the byte order of this machine.
  [[nodiscard]] std::span<const std::byte> bytes() const noexcept {
    return std::visit([](const auto& all) { return std::as_bytes(std::span(all)); }, indices);
  }
};

/// Writes `indices` in this format: the same triangles with the same windings, each strip whole unless a batch ends in
/// it. `indices` are the result of strip_indices(), or any triangle strips with restart_index between them, stitched by
/// repeated indices or not. Strips keep their order, except that in the stitched form a strip of odd length waits for
/// the next such strip, so that no index is spent on parity. Linear time. Throws std::invalid_argument for a limit that
/// is too low, and std::length_error when 16 bits are wanted and an index is too high.
[[nodiscard]] IndexBuffer format_strips(std::span<const std::uint32_t> indices, const StripFormat& format = {});

}  // namespace restrip
