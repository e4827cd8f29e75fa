// LiveBuffer: an index buffer in any form that StripFormat describes, kept in step with a mesh.
//
//   std::vector<Triangle> changed;
//   mesh.watch(&changed);
//   LiveBuffer buffer({.form = StripForm::stitched});
//   ... operations ...
//   for (const IndexRange& range : buffer.update(mesh, changed)) upload(range);    // of buffer.bytes()
//   changed.clear();
//
// It is a StripBuffer or a TriangleListBuffer with indices of 16 or 32 bits, chosen at run time; their headers say what
// updates cost. IndexWidth::automatic uses 16 bits until a vertex number is 65,535 or above, then 32.
//
// Hardware that limits the indices of a draw call: draw a stitched buffer in windows of N indices, N even. Window i is
// [(N - 2) i, (N - 2) i + N), cut off at the end of the buffer. Windows overlap by two indices, so each triangle is in
// one, and begin at even places, so windings stay. An update does not change which window a place is in.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <utility>
#include <variant>
#include <vector>

#include "restrip/mesh/mesh.hpp"
#include "restrip/output/strip_buffer.hpp"
#include "restrip/output/strip_format.hpp"
#include "restrip/output/triangle_list_buffer.hpp"
#include "restrip/precondition.hpp"

namespace restrip {

class LiveBuffer {
 public:
  /// Empty; the first update writes the whole buffer. Live buffers do not support batches (limits of a batch throw
  /// std::invalid_argument; see above for a remedy), and stay strips even if a list is shorter. `layout` matters to
  /// strips only; throws as their buffer does.
  RESTRIP_COLD explicit LiveBuffer(const StripFormat& format = {}, const LayoutOptions& layout = {})
      : format_(format), layout_(layout) {
    if (format.most_vertices != 0 || format.most_indices != 0)
      RESTRIP_THROW(std::invalid_argument,
                    "restrip: a live buffer has no batches; draw a stitched one in windows (live_buffer.hpp)");
    make(format.width == IndexWidth::bits32);
    returned_ = device_ = {index_bytes(), 0};
  }

  /// Writes the whole buffer, which the caller uploads to a device with room(). Linear time. Throws as the rebuild() of
  /// its buffer does.
  template <NumberedMesh Mesh>
  void rebuild(const Mesh& mesh);
  /// Brings the buffer in step with the mesh, like the update() of its buffer, and throws the same; then the next
  /// update writes everything. The result is valid until the next call.
  template <NumberedMesh Mesh>
  Upload update(const Mesh& mesh, std::span<const std::uint32_t> changed, const RangeOptions& options = {});
  /// Makes the next update also return the ranges of the last one, for a caller that has not uploaded them. It reports
  /// an outgrown buffer if the device's, as it was before the last update, is outgrown then.
  void keep_upload() noexcept {
    kept_ = true;
    std::visit([](auto& buffer) { buffer.keep_ranges(); }, buffer_);
  }
  /// Makes the next update write the whole buffer: for meshes that have changed without a list of changes.
  void forget() noexcept { whole_ = true; }

  /// Makes room for a mesh of this many triangle numbers, here and on the device, at 2 indices a triangle or 3 in a
  /// list. If room() grows, the next update reports an outgrown buffer.
  void reserve(std::size_t triangles) {
    std::visit([triangles](auto& buffer) { buffer.reserve(triangles); }, buffer_);  // throws if the product wraps
    room_ = (std::max)(room_, (format_.form == StripForm::list ? 3 : 2) * triangles);
  }

  [[nodiscard]] const StripFormat& format() const noexcept { return format_; }
  [[nodiscard]] const LayoutOptions& layout() const noexcept { return layout_; }
  /// 2 or 4.
  [[nodiscard]] std::size_t index_bytes() const noexcept { return cells().index_bytes(); }
  [[nodiscard]] std::size_t size() const noexcept { return cells().size(); }
  /// The number of indices that the buffer on the device should have room for: a quarter more than when it was last
  /// outgrown, or the number reserved.
  [[nodiscard]] std::size_t room() const noexcept { return room_; }
  /// In the byte order of this machine.
  [[nodiscard]] std::span<const std::byte> bytes() const noexcept { return cells().bytes(); }
  /// The indices, if they have 32 or 16 bits; else empty.
  [[nodiscard]] std::span<const std::uint32_t> indices() const noexcept { return cells().wide_indices(); }
  [[nodiscard]] std::span<const std::uint16_t> indices16() const noexcept { return cells().narrow_indices(); }
  /// The ranges to draw, one draw call or one entry of a multi-draw each: the runs of StripForm::lengths, else the
  /// whole buffer without the padding of a list. `draws` is overwritten.
  void draws(std::vector<IndexRange>& draws) const {
    if (format_.form == StripForm::lengths) return std::get<StripBuffer>(buffer_).draws(draws);
    draws.assign(size() == 0 ? 0 : 1, {0, format_.form == StripForm::list ? size() / 3 * 3 : size()});
  }

  using Buffer = std::variant<StripBuffer, TriangleListBuffer>;
  /// The buffer itself, for members that only one kind has.
  [[nodiscard]] Buffer& buffer() noexcept { return buffer_; }
  /// Makes the next update return all of it, after it was replaced by another of the same form.
  void keep_all() noexcept {
    keep_upload();
    all_changed_ = true;
  }

 private:
  friend class detail::LiveState;
  /// Of the buffer on the device.
  struct Extent {
    std::size_t index_bytes = 0;
    std::size_t room = 0;  ///< in indices
    friend bool operator==(const Extent&, const Extent&) = default;
  };
  template <class Mesh>
  void write_all(const Mesh& mesh, bool stays_wide);
  RESTRIP_COLD void make(bool wide) {
    const IndexWidth width = wide ? IndexWidth::bits32 : IndexWidth::bits16;
    if (format_.form == StripForm::list)
      buffer_.emplace<TriangleListBuffer>(width);
    else
      buffer_.emplace<StripBuffer>(StripBuffer(format_.form, layout_, width));  // may throw before it
  }
  [[nodiscard]] const detail::Cells& cells() const noexcept {
    return std::visit([](const auto& buffer) -> const detail::Cells& { return buffer.cells(); }, buffer_);
  }
  void make_room() noexcept {
    if (size() > room_) room_ = size() + size() / 4;
    returned_ = {index_bytes(), room_};
  }
  template <class Mesh>
  [[nodiscard]] static bool fits_16_bits(const Mesh& mesh, std::uint32_t t) {
    if (t >= mesh.triangle_bound() || !mesh.has_triangle(t)) return true;
    const auto [a, b, c] = detail::corners_from(mesh, mesh.halfedge(t));
    return (std::max)({a, b, c}) <= highest_index16;
  }

  StripFormat format_;
  LayoutOptions layout_;
  Buffer buffer_;
  bool whole_ = true;         // the next update writes everything
  bool all_changed_ = false;  // since the device was last written
  bool kept_ = false;         // the caller does not have the result of the last update
  std::size_t room_ = 0;
  Extent device_;    // that the caller knew before the last update
  Extent returned_;  // by the last update
  IndexRange all_;
};

template <NumberedMesh Mesh>
void LiveBuffer::rebuild(const Mesh& mesh) {
  write_all(mesh, false);
  make_room();
  kept_ = false;
}

template <NumberedMesh Mesh>
Upload LiveBuffer::update(const Mesh& mesh, std::span<const std::uint32_t> changed, const RangeOptions& options) {
  if (!std::exchange(kept_, true)) {  // until this update returns, its caller has only what the last one returned
    device_ = returned_;
    all_changed_ = false;
  }
  const bool widens =
      format_.width == IndexWidth::automatic && index_bytes() == 2 &&
      !std::all_of(changed.begin(), changed.end(), [&](std::uint32_t t) { return fits_16_bits(mesh, t); });
  std::span<const IndexRange> ranges{&all_, 1};
  if (whole_ || widens) {
    write_all(mesh, index_bytes() == 4);  // a history has no frame that narrows
  } else {
    whole_ = true;
    ranges = std::visit([&](auto& buffer) { return buffer.update(mesh, changed, options); }, buffer_);
    whole_ = false;
  }
  make_room();
  kept_ = false;
  const bool outgrown = returned_ != device_;
  if (outgrown || all_changed_) {
    all_ = {0, size()};
    ranges = {&all_, 1};
  }
  if (size() == 0) ranges = {};
  return {ranges, outgrown};
}

template <class Mesh>
RESTRIP_COLD void LiveBuffer::write_all(const Mesh& mesh, bool stays_wide) {
  whole_ = all_changed_ = true;  // also if no memory is left for a buffer of the other width
  if (format_.width == IndexWidth::automatic) {
    bool wide = stays_wide;
    for (std::uint32_t t = 0; t < mesh.triangle_bound() && !wide; ++t) wide = !fits_16_bits(mesh, t);
    make(wide);
  }
  std::visit([&](auto& buffer) { buffer.rebuild(mesh); }, buffer_);
  whole_ = false;
}

extern template void LiveBuffer::rebuild(const StripMesh&);
extern template Upload LiveBuffer::update(const StripMesh&, std::span<const std::uint32_t>, const RangeOptions&);

}  // namespace restrip
