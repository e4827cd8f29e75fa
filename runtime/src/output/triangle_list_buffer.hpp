// TriangleListBuffer: a triangle list with a slot for each triangle; triangle_list_buffer.cpp tells how. LiveBuffer
// (output/live_buffer.hpp) is its manual.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "output/cells.hpp"
#include "restrip/mesh/strip_mesh.hpp"
#include "restrip/output/strip_format.hpp"

namespace restrip {

class TriangleListBuffer {
 public:
  using Range = IndexRange;

  /// Empty; the first update writes the whole buffer. `width`: 16 bits for IndexWidth::bits16, else 32.
  explicit TriangleListBuffer(IndexWidth width = IndexWidth::bits32) noexcept : cells_(width) {}
  /// Writes all triangles. Linear time. Throws as rebuild() does.
  explicit TriangleListBuffer(const StripMesh& mesh, IndexWidth width = IndexWidth::bits32) : cells_(width) {
    rebuild(mesh);
  }

  /// Rewrites the whole buffer. Throws std::length_error when a vertex number does not fit into an index (the index
  /// with all bits set restarts strips and is not available), or std::bad_alloc, or what the mesh throws; then the
  /// buffer is incomplete, and the next update rewrites it.
  void rebuild(const StripMesh& mesh);

  /// Brings the buffer in step with the mesh. `changed` names every triangle whose corners have changed since the last
  /// call, and every triangle inserted or removed; other triangles and repetitions do no harm. Returns the ranges whose
  /// indices may have changed, ascending and disjoint; valid until the next call. Time linear in `changed`, up to a
  /// logarithm and the growth of its arrays (reserve()). Throws as rebuild() does. The contents are then undefined, and
  /// the next update rewrites everything.
  std::span<const Range> update(const StripMesh& mesh, std::span<const std::uint32_t> changed,
                                const RangeOptions& ranges = {.merge_gap = 0});

  /// Makes the next update() also return the ranges of the last one, for a caller that has not uploaded them.
  void keep_ranges() noexcept { returned_ = false; }

  /// The indices, if they have 32 or 16 bits; else empty.
  [[nodiscard]] std::span<const std::uint32_t> indices() const noexcept { return cells_.wide_indices(); }
  [[nodiscard]] std::span<const std::uint16_t> indices16() const noexcept { return cells_.narrow_indices(); }
  [[nodiscard]] IndexWidth width() const noexcept { return cells_.width(); }
  [[nodiscard]] const detail::Cells& cells() const noexcept { return cells_; }
  /// Makes room for a mesh of this many triangles.
  void reserve(std::size_t triangles);

 private:
  static constexpr std::uint32_t no_slot = 0xFFFFFFFFU;

  std::array<std::uint32_t, 3> corners_of(const StripMesh& mesh, std::uint32_t t) const;
  void pad();
  void append(std::uint32_t t, const std::array<std::uint32_t, 3>& corners);
  /// Writes the corners in the rotation that keeps most indices.
  void write(std::uint32_t slot, const std::array<std::uint32_t, 3>& corners);

  detail::Cells cells_;
  std::vector<std::uint32_t> owner_;  // by slot
  std::vector<std::uint32_t> slot_;   // by triangle
  std::vector<std::uint32_t> free_;
  std::vector<Range> written_;
  bool stale_ = true;
  bool returned_ = true;  // whether written_ has been returned
};

}  // namespace restrip
