// Index buffers read as a graphics card reads them: bytes in, wound triangles out. Shares no code with the writers.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <utility>
#include <vector>

#include "restrip/output/strip_format.hpp"
#include "sample_meshes.hpp"

namespace restrip::form_reader {

using Triangles = std::vector<sample::Corners>;  // from the smallest corner, in order

class Reader {
 public:
  Reader(std::span<const std::byte> bytes, std::size_t width) : restart_(width == 2 ? 0xFFFFU : 0xFFFFFFFFU) {
    for (std::size_t at = 0; at < bytes.size(); at += width) {
      std::uint16_t narrow = 0;
      std::uint32_t wide = 0;
      if (width == 2) std::memcpy(&narrow, bytes.data() + at, 2);
      if (width == 4) std::memcpy(&wide, bytes.data() + at, 4);
      indices_.push_back(width == 2 ? narrow : wide);
    }
  }
  // One draw call of a triangle strip; `restarts`: primitive restart is enabled.
  void strip(std::size_t first, std::size_t count, bool restarts) {
    std::vector<std::uint32_t> last;
    for (std::size_t i = first; i < first + count; ++i) {
      if (restarts && indices_.at(i) == restart_) {
        last.clear();
        continue;
      }
      last.push_back(indices_.at(i));
      const std::size_t n = last.size();
      if (n >= 3 && n % 2 == 1) triangle(last[n - 3], last[n - 2], last[n - 1]);
      if (n >= 3 && n % 2 == 0) triangle(last[n - 2], last[n - 3], last[n - 1]);
    }
  }
  void list(std::size_t first, std::size_t count) {
    for (std::size_t i = first; i + 3 <= first + count; i += 3)
      triangle(indices_.at(i), indices_.at(i + 1), indices_.at(i + 2));
  }
  // The draw calls of a buffer in this form.
  void draw(StripForm form, std::span<const IndexRange> draws) {
    for (const auto& [first, count] : draws) {
      if (form == StripForm::list)
        list(first, count);
      else
        strip(first, count, form == StripForm::restart);
    }
  }
  [[nodiscard]] bool has_restart(const IndexRange& range) const {
    const auto first = indices_.begin() + static_cast<std::ptrdiff_t>(range.first);
    return std::find(first, first + static_cast<std::ptrdiff_t>(range.count), restart_) !=
           first + static_cast<std::ptrdiff_t>(range.count);
  }
  [[nodiscard]] std::size_t vertices(std::size_t first, std::size_t count) const {
    std::vector<std::uint32_t> all(indices_.begin() + static_cast<std::ptrdiff_t>(first),
                                   indices_.begin() + static_cast<std::ptrdiff_t>(first + count));
    std::erase(all, restart_);
    std::sort(all.begin(), all.end());
    return static_cast<std::size_t>(std::unique(all.begin(), all.end()) - all.begin());
  }
  [[nodiscard]] Triangles triangles() && { return sample::sorted(std::move(drawn_)); }

 private:
  // Without an area nothing is drawn; a vertex that restarts elsewhere would be read beyond the vertex buffer.
  void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    if (a != b && b != c && c != a) drawn_.push_back({a, b, c});
  }

  std::uint32_t restart_;
  std::vector<std::uint32_t> indices_;
  Triangles drawn_;
};

// What the draw calls of a buffer draw.
inline Triangles drawn(std::span<const std::byte> bytes, std::size_t width, StripForm form,
                       std::span<const IndexRange> draws) {
  Reader reader(bytes, width);
  reader.draw(form, draws);
  return std::move(reader).triangles();
}

// What strips with restart indices draw.
template <class Index>
Triangles read_strips(std::span<const Index> indices) {
  Reader reader(std::as_bytes(indices), sizeof(Index));
  reader.strip(0, indices.size(), true);
  return std::move(reader).triangles();
}

// Everything that the buffer draws, batch by batch.
inline Triangles read(const IndexBuffer& buffer) {
  Reader reader(buffer.bytes(), buffer.index_bytes());
  if (buffer.form == StripForm::lengths) {
    std::size_t first = 0;
    for (const std::uint32_t length : buffer.lengths) {
      reader.strip(first, length, false);
      first += length;
    }
    return std::move(reader).triangles();
  }
  reader.draw(buffer.form, buffer.batches);
  return std::move(reader).triangles();
}

}  // namespace restrip::form_reader
