// A live buffer: one of two kinds, of one of two widths, and what the device of its caller holds.
//
// Outline. An update hands the changes to the buffer of strips or the triangle list. It writes everything instead if it
// is the first, if an exception has ended the last one, or if a vertex no longer fits into 16 bits of IndexWidth::
// automatic. Until an update returns, its caller has only what the last one returned, so ranges of an update that threw
// are returned by the next one.
//
// Invariant: room_ is at least the size of the buffer, and `returned_` what the caller was told of it.
#include "restrip/output/live_buffer.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>
#include <variant>

#include "output/strip_buffer.hpp"
#include "output/triangle_list_buffer.hpp"
#include "restrip/precondition.hpp"

namespace restrip {

struct LiveBuffer::Buffer {
  [[nodiscard]] const detail::Cells& cells() const noexcept {
    return std::visit([](const auto& one) -> const detail::Cells& { return one.cells(); }, kind);
  }
  std::variant<StripBuffer, TriangleListBuffer> kind;
};

namespace {

bool fits_16_bits(const StripMesh& mesh, Triangle t) noexcept {
  if (!mesh.alive(t)) return true;
  const std::array<Vertex, 3> corner = mesh.corners(t);
  return (std::max)({corner[0], corner[1], corner[2]}) <= highest_index16;
}

}  // namespace

RESTRIP_COLD LiveBuffer::LiveBuffer(const StripFormat& format, const LayoutOptions& layout)
    : format_(format), layout_(layout), buffer_(std::make_unique<Buffer>()) {
  if (format.most_vertices != 0 || format.most_indices != 0)
    RESTRIP_THROW(std::invalid_argument,
                  "restrip: a live buffer has no batches; draw a stitched one in windows (live_buffer.hpp)");
  if (!layout.in_range())
    RESTRIP_THROW(std::invalid_argument,
                  "restrip: LayoutOptions allow a cache of 64, a waste of 1,000,000 and a work of 100");
  make(format.width == IndexWidth::bits32);
  returned_ = device_ = {index_bytes(), 0};
}
LiveBuffer::LiveBuffer(LiveBuffer&& other) noexcept = default;
LiveBuffer& LiveBuffer::operator=(LiveBuffer&& other) noexcept = default;
LiveBuffer::~LiveBuffer() = default;

RESTRIP_COLD void LiveBuffer::make(bool wide) {
  const IndexWidth width = wide ? IndexWidth::bits32 : IndexWidth::bits16;
  if (format_.form == StripForm::list)
    buffer_->kind.emplace<TriangleListBuffer>(width);
  else
    buffer_->kind.emplace<StripBuffer>(StripBuffer(format_.form, layout_, width));  // may throw before it
}

void LiveBuffer::make_room() noexcept {
  if (size() > room_) room_ = size() + size() / 4;
  returned_ = {index_bytes(), room_};
}

RESTRIP_COLD void LiveBuffer::write_all(const StripMesh& mesh) {
  whole_ = all_changed_ = true;  // also if no memory is left for a buffer of the other width
  if (format_.width == IndexWidth::automatic) {
    bool wide = false;
    for (Triangle t = 0; t < mesh.triangle_bound() && !wide; ++t) wide = !fits_16_bits(mesh, t);
    make(wide);
  }
  std::visit([&](auto& one) { one.rebuild(mesh); }, buffer_->kind);
  whole_ = false;
}

void LiveBuffer::rebuild(const StripMesh& mesh) {
  write_all(mesh);
  make_room();
  kept_ = false;
}

Upload LiveBuffer::update(const StripMesh& mesh, std::span<const Triangle> changed, const RangeOptions& options) {
  if (!std::exchange(kept_, true)) {
    device_ = returned_;
    all_changed_ = false;
  }
  const bool widens = format_.width == IndexWidth::automatic && index_bytes() == 2 &&
                      !std::all_of(changed.begin(), changed.end(), [&](Triangle t) { return fits_16_bits(mesh, t); });
  std::span<const IndexRange> ranges{&all_, 1};
  if (whole_ || widens) {
    write_all(mesh);
  } else {
    whole_ = true;
    ranges = std::visit([&](auto& one) { return one.update(mesh, changed, options); }, buffer_->kind);
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

void LiveBuffer::keep_upload() noexcept {
  kept_ = true;
  std::visit([](auto& one) { one.keep_ranges(); }, buffer_->kind);
}

void LiveBuffer::reserve(std::size_t triangles) {
  std::visit([triangles](auto& one) { one.reserve(triangles); }, buffer_->kind);  // throws if the product wraps
  room_ = (std::max)(room_, (format_.form == StripForm::list ? 3 : 2) * triangles);
}

std::size_t LiveBuffer::index_bytes() const noexcept { return buffer_->cells().index_bytes(); }
std::size_t LiveBuffer::size() const noexcept { return buffer_->cells().size(); }
std::span<const std::byte> LiveBuffer::bytes() const noexcept { return buffer_->cells().bytes(); }
std::span<const std::uint32_t> LiveBuffer::indices() const noexcept { return buffer_->cells().wide_indices(); }
std::span<const std::uint16_t> LiveBuffer::indices16() const noexcept { return buffer_->cells().narrow_indices(); }

void LiveBuffer::draws(std::vector<IndexRange>& draws) const {
  if (format_.form == StripForm::lengths) return std::get<StripBuffer>(buffer_->kind).draws(draws);
  draws.assign(size() == 0 ? 0 : 1, {0, format_.form == StripForm::list ? size() / 3 * 3 : size()});
}

}  // namespace restrip
