// A triangle list with a slot for each triangle: three indices each.
//
// Outline. The slot of a removed triangle goes to a new one, or else to the last triangle of the buffer, so the buffer
// has no gaps. A triangle keeps its slot, and is written in the rotation that keeps most indices. Slots are given in
// the order of the triangle numbers, so numbers in an order for the vertex cache make a buffer in that order.
//
// A 16-bit buffer with an odd number of triangles has one more index at its end, which draws nothing, so that its
// length is a multiple of four bytes.
//
// Invariant: owner_ and slot_ are inverse to each other. Cost: linear in the triangles changed, but for sorting ranges.
#include "output/triangle_list_buffer.hpp"

#include <algorithm>
#include <utility>

#include "output/strip_buffer.hpp"

namespace restrip {

void TriangleListBuffer::rebuild(const StripMesh& mesh) {
  stale_ = true;
  cells_.clear();
  owner_.clear();
  slot_.assign(mesh.triangle_bound(), no_slot);
  for (std::uint32_t t = 0; t < slot_.size(); ++t)
    if (mesh.alive(t)) append(t, corners_of(mesh, t));
  pad();
  written_.assign(cells_.empty() ? 0 : 1, {0, cells_.size()});
  returned_ = true;
  stale_ = false;
}

std::span<const IndexRange> TriangleListBuffer::update(const StripMesh& mesh, std::span<const std::uint32_t> changed,
                                                       const RangeOptions& ranges) {
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
    if (t >= slot_.size() || slot_[t] == no_slot || (t < mesh.triangle_bound() && mesh.alive(t))) continue;
    free_.push_back(slot_[t]);
    owner_[slot_[t]] = no_slot;
    slot_[t] = no_slot;
  }
  for (const std::uint32_t t : changed) {
    if (t >= mesh.triangle_bound() || !mesh.alive(t)) continue;
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

void TriangleListBuffer::reserve(std::size_t triangles) {
  owner_.reserve(triangles);  // throws before the product below wraps
  slot_.reserve(triangles);
  cells_.reserve(3 * triangles + 1);
}

std::array<std::uint32_t, 3> TriangleListBuffer::corners_of(const StripMesh& mesh, std::uint32_t t) const {
  const std::array<std::uint32_t, 3> corner = mesh.corners(t);
  cells_.expect_fits((std::max)({corner[0], corner[1], corner[2]}));
  return corner;
}

void TriangleListBuffer::pad() {
  if (cells_.narrow() && cells_.size() % 2 != 0) cells_.append(std::array{cells_[cells_.size() - 1]});
}

void TriangleListBuffer::append(std::uint32_t t, const std::array<std::uint32_t, 3>& corners) {
  cells_.append(corners);
  owner_.push_back(t);
  slot_[t] = static_cast<std::uint32_t>(owner_.size() - 1);
}

void TriangleListBuffer::write(std::uint32_t slot, const std::array<std::uint32_t, 3>& corners) {
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

}  // namespace restrip
