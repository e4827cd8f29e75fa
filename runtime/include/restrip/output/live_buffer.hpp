// LiveBuffer: an index buffer in any form that StripFormat describes, kept in step with a mesh.
//
//   std::vector<Triangle> changed;
//   mesh.watch(&changed);
//   LiveBuffer buffer({.form = StripForm::stitched});
//   ... operations ...
//   for (const IndexRange& range : buffer.update(mesh, changed)) upload(range);    // of buffer.bytes()
//   changed.clear();
//
// IndexWidth::automatic uses 16 bits until a vertex number is 65,535 or above, then 32.
//
// Strips are cut into *runs* of at most 36 triangles, each in its place in the buffer. When triangles change, little
// more than their runs is written again. While it changes, the buffer of a scanned mesh has some 1.09 times the indices
// of strip_indices(), also after scattered operations, a stitched one up to 1.25 times the indices of a stitched strip.
// Strips that repeat no index, such as strips of a grid, take more: one cut for every 28 triangles is already 11 %.
// Draw StripForm::restart as one triangle strip with primitive restart, StripForm::stitched without it, and
// StripForm::lengths by the runs that draws() lists. At first runs are in an order that a vertex cache likes; new runs
// are put next to their neighbours. An update takes time linear in the changed triangles, up to a logarithm for the
// ranges that it returns; only the growth of arrays is linear in the mesh (reserve()). Memory: 4 bytes a triangle, the
// indices, and 40 bytes a run.
//
// StripForm::list is a triangle list with a slot of three indices for each triangle, of which an update rewrites only
// the corners that changed. It is the better choice if bytes written or update times matter most, or if vertices are
// expensive and the triangles are in an order for the vertex cache, which their numbers keep. Strips take half the
// memory, but need a colouring. A list of 16 bits with an odd number of triangles has one more index at its end, which
// draws nothing. bench/level.cpp measures both.
//
// Hardware that limits the indices of a draw call: draw a stitched buffer in windows of N indices, N even. Window i is
// [(N - 2) i, (N - 2) i + N), cut off at the end of the buffer. Windows overlap by two indices, so each triangle is in
// one, and begin at even places, so windings stay. An update does not change which window a place is in.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "restrip/mesh/strip_mesh.hpp"
#include "restrip/output/strip_format.hpp"

namespace restrip {

class LiveBuffer {
 public:
  /// Empty; the first update writes the whole buffer. Live buffers do not support batches (limits of a batch throw
  /// std::invalid_argument; see above for a remedy), and stay strips even if a list is shorter. `layout` matters to
  /// strips only; std::invalid_argument if it is out of range.
  explicit LiveBuffer(const StripFormat& format = {}, const LayoutOptions& layout = {});
  LiveBuffer(LiveBuffer&& other) noexcept;
  LiveBuffer& operator=(LiveBuffer&& other) noexcept;
  ~LiveBuffer();

  /// Writes the whole buffer, without gaps, which the caller uploads to a device with room(). Linear time. Triangles on
  /// solid cycles, which no valid colouring has, are left out. Throws std::length_error when a vertex number does not
  /// fit into an index (the index with all bits set is not available), with the vertex and what to do, or
  /// std::bad_alloc; then the next update writes everything.
  void rebuild(const StripMesh& mesh);
  /// Brings the buffer in step with the mesh. `changed` names every triangle whose corners, neighbours or colours have
  /// changed since the last call, and every triangle inserted or removed, as StripMesh::watch does; repetitions do no
  /// harm. Returns the ranges whose indices may have changed; the buffer may have grown or shrunk, by multiples of four
  /// bytes. Valid until the next call. Throws as rebuild() does.
  Upload update(const StripMesh& mesh, std::span<const Triangle> changed, const RangeOptions& options = {});
  /// Makes the next update also return the ranges of the last one, for a caller that has not uploaded them. It reports
  /// an outgrown buffer if the device's, as it was before the last update, is outgrown then.
  void keep_upload() noexcept;
  /// Makes the next update write the whole buffer: for meshes that have changed without a list of changes.
  void forget() noexcept { whole_ = true; }
  /// Makes room for a mesh of this many triangle numbers, here and on the device, at 2 indices a triangle or 3 in a
  /// list. If room() grows, the next update reports an outgrown buffer. Throws std::length_error if they are too many
  /// for any memory, or std::bad_alloc.
  void reserve(std::size_t triangles);

  [[nodiscard]] const StripFormat& format() const noexcept { return format_; }
  [[nodiscard]] const LayoutOptions& layout() const noexcept { return layout_; }
  /// 2 or 4.
  [[nodiscard]] std::size_t index_bytes() const noexcept;
  [[nodiscard]] std::size_t size() const noexcept;
  /// The number of indices that the buffer on the device should have room for: a quarter more than when it was last
  /// outgrown, or the number reserved.
  [[nodiscard]] std::size_t room() const noexcept { return room_; }
  /// In the byte order of this machine.
  [[nodiscard]] std::span<const std::byte> bytes() const noexcept;
  /// The indices, if they have 32 or 16 bits; else empty.
  [[nodiscard]] std::span<const std::uint32_t> indices() const noexcept;
  [[nodiscard]] std::span<const std::uint16_t> indices16() const noexcept;
  /// The ranges to draw, one draw call or one entry of a multi-draw each: the runs of StripForm::lengths, else the
  /// whole buffer without the padding of a list. `draws` is overwritten.
  void draws(std::vector<IndexRange>& draws) const;

 private:
  struct Buffer;
  /// Of the buffer on the device.
  struct Extent {
    std::size_t index_bytes = 0;
    std::size_t room = 0;  ///< in indices
    friend bool operator==(const Extent&, const Extent&) = default;
  };
  void make(bool wide);
  void make_room() noexcept;
  void write_all(const StripMesh& mesh);

  StripFormat format_;
  LayoutOptions layout_;
  std::unique_ptr<Buffer> buffer_;
  bool whole_ = true;         // the next update writes everything
  bool all_changed_ = false;  // since the device was last written
  bool kept_ = false;         // the caller does not have the result of the last update
  std::size_t room_ = 0;
  Extent device_;    // that the caller knew before the last update
  Extent returned_;  // by the last update
  IndexRange all_;
};

}  // namespace restrip
