// Cells: the indices of a buffer, of 16 or 32 bits. The width is chosen at run time, so that what works on indices is
// compiled once: it reads and writes 32 bits, of which the cells keep the lower 16 if they are narrow.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "restrip/mesh/strip_mesh.hpp"
#include "restrip/output/strip_format.hpp"
#include "restrip/precondition.hpp"

namespace restrip::detail {

class Cells {
 public:
  /// 16 bits for IndexWidth::bits16, else 32.
  explicit Cells(IndexWidth width) noexcept : narrow_(width == IndexWidth::bits16) {}

  [[nodiscard]] bool narrow() const noexcept { return narrow_; }
  [[nodiscard]] IndexWidth width() const noexcept { return narrow_ ? IndexWidth::bits16 : IndexWidth::bits32; }
  [[nodiscard]] std::size_t index_bytes() const noexcept { return narrow_ ? 2 : 4; }
  /// The index with all bits set, which restarts strips.
  [[nodiscard]] std::uint32_t restart() const noexcept { return narrow_ ? 0xFFFFU : 0xFFFFFFFFU; }
  void expect_fits(std::uint32_t vertex) const {
    if (vertex >= restart()) refuse_vertex(vertex);
  }
  /// Empty if the indices have the other width.
  [[nodiscard]] std::span<const std::uint32_t> wide_indices() const noexcept { return cells32_; }
  [[nodiscard]] std::span<const std::uint16_t> narrow_indices() const noexcept { return cells16_; }
  [[nodiscard]] std::span<const std::byte> bytes() const noexcept {
    return narrow_ ? std::as_bytes(narrow_indices()) : std::as_bytes(wide_indices());
  }

  [[nodiscard]] std::size_t size() const noexcept { return narrow_ ? cells16_.size() : cells32_.size(); }
  [[nodiscard]] bool empty() const noexcept { return size() == 0; }
  [[nodiscard]] std::uint32_t operator[](std::size_t i) const noexcept { return narrow_ ? cells16_[i] : cells32_[i]; }
  void set(std::size_t i, std::uint32_t index) noexcept {
    narrow_ ? void(cells16_[i] = static_cast<std::uint16_t>(index)) : void(cells32_[i] = index);
  }
  /// Writes indices from `first` on, from the first that differs to the last. Returns what it has written.
  IndexRange write(std::size_t first, std::span<const std::uint32_t> indices) noexcept {
    const std::uint32_t* const then = indices.data();
    std::size_t begin = 0;
    std::size_t end = indices.size();
    const auto write_to = [&]<class Index>(Index* now) {
      while (begin < end && now[begin] == then[begin]) ++begin;
      while (begin < end && now[end - 1] == then[end - 1]) --end;
      for (std::size_t i = begin; i < end; ++i) now[i] = static_cast<Index>(then[i]);
    };
    narrow_ ? write_to(cells16_.data() + first) : write_to(cells32_.data() + first);
    return {first + begin, end - begin};
  }
  /// The same index, 0 or restart(), in all cells from `first` to `end`.
  void fill(std::size_t first, std::size_t end, std::uint32_t index) noexcept {
    if (first < end) std::memset(at(first), static_cast<int>(index & 0xFFU), (end - first) * index_bytes());
  }
  /// Copies cells of cells of the same width, perhaps these.
  void copy(const Cells& from, std::size_t first, std::size_t count, std::size_t to) noexcept {
    if (count != 0) std::memmove(at(to), from.bytes().data() + first * index_bytes(), count * index_bytes());
  }

  void clear() noexcept { narrow_ ? cells16_.clear() : cells32_.clear(); }
  void reserve(std::size_t count) { narrow_ ? cells16_.reserve(count) : cells32_.reserve(count); }
  void make_room(std::size_t count) {
    narrow_ ? detail::make_room(cells16_, count) : detail::make_room(cells32_, count);
  }
  void resize(std::size_t count, std::uint32_t index = 0) {
    narrow_ ? cells16_.resize(count, static_cast<std::uint16_t>(index)) : cells32_.resize(count, index);
  }
  // Not by resize(), of which GCC 12 believes that it may grow without bound.
  void drop_last(std::size_t count) noexcept {
    const auto dropped = static_cast<std::ptrdiff_t>(count);
    if (narrow_)
      cells16_.erase(cells16_.end() - dropped, cells16_.end());
    else
      cells32_.erase(cells32_.end() - dropped, cells32_.end());
  }
  void append(std::span<const std::uint32_t> indices) {
    const std::size_t first = size();
    resize(first + indices.size());
    write(first, indices);
  }

  [[noreturn]] RESTRIP_COLD void refuse_vertex(std::uint32_t vertex) const {
    const std::string number = std::to_string(vertex);
    const std::string sentence = narrow_
                                     ? "restrip: vertex " + number +
                                           " does not fit into indices of 16 bits, which name vertices up to 65534: " +
                                           "choose 32 bits or IndexWidth::automatic, or give the vertices lower "
                                           "numbers, as LiveMesh::pack() does"
                                     : "restrip: vertex " + number + " does not fit into the indices of the buffer";
    RESTRIP_THROW(std::length_error, sentence.c_str());
  }

 private:
  void* at(std::size_t i) noexcept { return narrow_ ? static_cast<void*>(cells16_.data() + i) : cells32_.data() + i; }

  bool narrow_;
  std::vector<std::uint16_t> cells16_;
  std::vector<std::uint32_t> cells32_;
};

}  // namespace restrip::detail
