// TriangleListBuffer: an index buffer of plain triangles, three indices each, that is kept in step with a mesh,
// rewriting only the corners that changed.
//
//   std::vector<Triangle> changed;
//   mesh.watch(&changed);
//   TriangleListBuffer buffer(mesh);                 // upload buffer.indices(), draw them as a triangle list
//   ... operations ...
//   for (const auto& range : buffer.update(mesh, changed)) upload(range);
//   changed.clear();
//
// A 16-bit buffer with an odd number of triangles has one more index at its end, which draws nothing, so that its
// length is a multiple of four bytes.
//
// Every triangle has a slot. The slot of a removed triangle goes to a new one, or else to the last triangle of the
// buffer, so that the buffer has no gaps. Slots are given in the order of the triangle numbers, so numbers in an order
// for the vertex cache make a buffer in that order.
//
// Compared with StripBuffer. A list is the better choice if bytes written or update times matter most, or if vertices
// are expensive and the triangles are in an order for the vertex cache. Strips take half the memory, but need a
// colouring. bench/level.cpp measures both.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "restrip/mesh/mesh.hpp"
#include "restrip/output/impl/cells.hpp"
#include "restrip/output/strip_buffer.hpp"

namespace restrip {

class TriangleListBuffer {
 public:
  using Range = IndexRange;

  /// Empty; the first update writes the whole buffer. `width`: 16 bits for IndexWidth::bits16, else 32.
  explicit TriangleListBuffer(IndexWidth width = IndexWidth::bits32) noexcept : cells_(width) {}
  /// Writes all triangles. Linear time. Throws as rebuild() does.
  template <NumberedMesh Mesh>
  explicit TriangleListBuffer(const Mesh& mesh, IndexWidth width = IndexWidth::bits32) : cells_(width) {
    rebuild(mesh);
  }

  /// Rewrites the whole buffer. Throws std::length_error when a vertex number does not fit into an index (the index
  /// with all bits set restarts strips and is not available), or std::bad_alloc, or what the mesh throws; then the
  /// buffer is incomplete, and the next update rewrites it.
  template <NumberedMesh Mesh>
  void rebuild(const Mesh& mesh) {
    stale_ = true;
    cells_.clear();
    owner_.clear();
    slot_.assign(mesh.triangle_bound(), no_slot);
    for (std::uint32_t t = 0; t < slot_.size(); ++t)
      if (mesh.has_triangle(t)) append(t, corners_of(mesh, t));
    pad();
    written_.assign(cells_.empty() ? 0 : 1, {0, cells_.size()});
    returned_ = true;
    stale_ = false;
  }

  /// Brings the buffer in step with the mesh. `changed` names every triangle whose corners have changed since the last
  /// call, and every triangle inserted or removed; other triangles and repetitions do no harm. Returns the ranges whose
  /// indices may have changed, ascending and disjoint; valid until the next call. Time linear in `changed`, up to a
  /// logarithm and the growth of its arrays (reserve()). Throws as rebuild() does. The contents are then undefined, and
  /// the next update rewrites everything.
  template <NumberedMesh Mesh>
  std::span<const Range> update(const Mesh& mesh, std::span<const std::uint32_t> changed,
                                const RangeOptions& ranges = {.merge_gap = 0}) {
    if (stale_) {
      rebuild(mesh);
      return written_;
    }
    stale_ = true;
    const std::size_t old_size = cells_.size();
    const std::uint32_t old_padding = old_size == 3 * owner_.size() ? 0 : cells_[old_size - 1];
    cells_.resize(3 * owner_.size());
    if (std::exchange(returned_, true)) written_.clear();
    if (slot_.size() < mesh.triangle_bound()) slot_.resize(mesh.triangle_bound(), no_slot);
    free_.clear();
    for (const std::uint32_t t : changed) {
      if (t >= slot_.size() || slot_[t] == no_slot || (t < mesh.triangle_bound() && mesh.has_triangle(t))) continue;
      free_.push_back(slot_[t]);
      owner_[slot_[t]] = no_slot;
      slot_[t] = no_slot;
    }
    for (const std::uint32_t t : changed) {
      if (t >= mesh.triangle_bound() || !mesh.has_triangle(t)) continue;
      const std::array<std::uint32_t, 3> corners = corners_of(mesh, t);
      if (slot_[t] == no_slot && free_.empty()) {
        append(t, corners);
        written_.push_back({cells_.size() - 3, 3});
        continue;
      }
      if (slot_[t] == no_slot) {
        slot_[t] = free_.back();
        owner_[free_.back()] = t;
        free_.pop_back();
      }
      write(slot_[t], corners);
    }
    // The last triangles fill the remaining slots.
    detail::sort_unique(free_);
    for (std::size_t filled = 0; filled < free_.size();) {
      const auto last = static_cast<std::uint32_t>(owner_.size() - 1);
      if (owner_[last] == no_slot) {
        free_.pop_back();
      } else {
        const std::uint32_t slot = free_[filled++];
        write(slot,
              {cells_[std::size_t{3} * last], cells_[std::size_t{3} * last + 1], cells_[std::size_t{3} * last + 2]});
        owner_[slot] = owner_[last];
        slot_[owner_[last]] = slot;
      }
      owner_.pop_back();
      cells_.drop_last(3);
    }
    free_.clear();
    pad();
    if (cells_.size() != 3 * owner_.size() && (cells_.size() != old_size || cells_[old_size - 1] != old_padding))
      written_.push_back({cells_.size() - 1, 1});
    detail::join_ranges(written_, cells_.size(), ranges.merge_gap, ranges.align / cells_.index_bytes());
    stale_ = false;
    return written_;
  }

  /// Makes the next update() also return the ranges of the last one, for a caller that has not uploaded them.
  void keep_ranges() noexcept { returned_ = false; }

  /// The indices, if they have 32 or 16 bits; else empty.
  [[nodiscard]] std::span<const std::uint32_t> indices() const noexcept { return cells_.wide_indices(); }
  [[nodiscard]] std::span<const std::uint16_t> indices16() const noexcept { return cells_.narrow_indices(); }
  [[nodiscard]] IndexWidth width() const noexcept { return cells_.width(); }
  [[nodiscard]] const detail::Cells& cells() const noexcept { return cells_; }
  /// Makes room for a mesh of this many triangles.
  void reserve(std::size_t triangles) {
    owner_.reserve(triangles);  // throws before the product below wraps
    slot_.reserve(triangles);
    cells_.reserve(3 * triangles + 1);
  }

 private:
  friend class detail::LiveState;
  static constexpr std::uint32_t no_slot = 0xFFFFFFFFU;

  template <class Mesh>
  std::array<std::uint32_t, 3> corners_of(const Mesh& mesh, std::uint32_t t) const {
    const std::array<std::uint32_t, 3> corner = detail::corners_from(mesh, mesh.halfedge(t));
    cells_.expect_fits((std::max)({corner[0], corner[1], corner[2]}));
    return corner;
  }
  void pad() {
    if (cells_.narrow() && cells_.size() % 2 != 0) cells_.append(std::array{cells_[cells_.size() - 1]});
  }
  void append(std::uint32_t t, const std::array<std::uint32_t, 3>& corners) {
    cells_.append(corners);
    owner_.push_back(t);
    slot_[t] = static_cast<std::uint32_t>(owner_.size() - 1);
  }
  /// Writes the corners in the rotation that keeps most indices.
  void write(std::uint32_t slot, const std::array<std::uint32_t, 3>& corners) {
    const std::size_t first = std::size_t{3} * slot;
    const std::array before{cells_[first], cells_[first + 1], cells_[first + 2]};
    const std::array after{corners[0], corners[1], corners[2], corners[0], corners[1]};
    std::size_t best = 0;
    int most = -1;
    for (std::size_t turn = 0; turn < 3; ++turn) {
      int same = 0;
      for (std::size_t i = 0; i < 3; ++i) same += static_cast<int>(before[i] == after[turn + i]);
      if (same > most) {
        most = same;
        best = turn;
      }
    }
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t now = after[best + i];
      if (before[i] == now) continue;
      cells_.set(first + i, now);
      written_.push_back({first + i, 1});
    }
  }

  detail::Cells cells_;
  std::vector<std::uint32_t> owner_;  // by slot
  std::vector<std::uint32_t> slot_;   // by triangle
  std::vector<std::uint32_t> free_;
  std::vector<Range> written_;
  bool stale_ = true;
  bool returned_ = true;  // whether written_ has been returned
};

}  // namespace restrip
