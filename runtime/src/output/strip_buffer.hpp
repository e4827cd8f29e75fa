// StripBuffer: strips cut into runs, kept in step with a mesh; strip_buffer.cpp tells how. LiveBuffer
// (output/live_buffer.hpp) is its manual.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "output/cells.hpp"
#include "output/run_places.hpp"
#include "restrip/mesh/strip_mesh.hpp"
#include "restrip/output/strip_format.hpp"

namespace restrip {

namespace detail {

/// Sorts ranges, widens them to multiples of `unit` indices, cuts them off at `end`, and joins ranges that are at most
/// `gap` indices apart.
void join_ranges(std::vector<IndexRange>& ranges, std::size_t end, std::size_t gap, std::size_t unit) noexcept;

}  // namespace detail

class StripBuffer {
 public:
  using Range = IndexRange;

  /// Empty; the first update writes the whole buffer. `form`: any but a list. `layout`: in range. `width`: 16 bits for
  /// IndexWidth::bits16, else 32.
  StripBuffer() = default;
  explicit StripBuffer(StripForm form, const LayoutOptions& layout = {}, IndexWidth width = IndexWidth::bits32);
  /// Writes the strips of a valid colouring. Linear time. Throws as rebuild() does.
  explicit StripBuffer(const StripMesh& mesh, IndexWidth width = IndexWidth::bits32) : cells_(width) { rebuild(mesh); }

  /// Rewrites the whole buffer, without gaps. Triangles on solid cycles, which no valid colouring has, are left out.
  /// Throws std::length_error when a vertex number does not fit into an index (the restart index is not available), or
  /// std::bad_alloc, or what the mesh throws; then the buffer is incomplete, and the next update rewrites it.
  void rebuild(const StripMesh& mesh);

  /// Brings the buffer in step with the mesh. `changed` names every triangle whose corners, neighbours or colours have
  /// changed since the last call, and every triangle inserted or removed, as StripMesh::watch does; repetitions do no
  /// harm. Returns the ranges whose indices may have changed, ascending and disjoint; the buffer may have grown or
  /// shrunk, by multiples of four bytes. Valid until the next call. Throws as rebuild() does. Then indices() is
  /// unchanged, unless the whole buffer was to be written, and the next update rewrites everything.
  std::span<const Range> update(const StripMesh& mesh, std::span<const std::uint32_t> changed,
                                const RangeOptions& ranges = {});

  /// Makes the next update() also return the ranges of the last one, for a caller that has not uploaded them.
  void keep_ranges() noexcept { returned_ = false; }

  /// The indices, if they have 32 or 16 bits; else empty. All bits are set between runs and in gaps, unless stitched.
  [[nodiscard]] std::span<const std::uint32_t> indices() const noexcept { return cells_.wide_indices(); }
  [[nodiscard]] std::span<const std::uint16_t> indices16() const noexcept { return cells_.narrow_indices(); }
  [[nodiscard]] IndexWidth width() const noexcept { return cells_.width(); }
  [[nodiscard]] const detail::Cells& cells() const noexcept { return cells_; }
  /// The runs in the order of the buffer, without the indices that separate them, for a multi-draw without restart.
  /// Linear in the runs. `draws` is overwritten.
  void draws(std::vector<Range>& draws) const;
  /// Number of runs.
  [[nodiscard]] std::size_t runs() const noexcept { return places_.runs(); }
  /// The number of indices of runs, separating indices included; the rest of the buffer is gaps.
  [[nodiscard]] std::size_t used() const noexcept { return places_.used(); }
  /// Makes room for a mesh of this many triangle numbers, at 2 indices each. Throws std::length_error if they are too
  /// many for any memory, or std::bad_alloc.
  void reserve(std::size_t triangles) {
    run_of_.reserve(triangles);  // throws before the product below wraps
    cells_.reserve(2 * triangles);
  }

 private:
  using State = detail::RunPlaces::State;
  static constexpr std::uint32_t nothing = 0xFFFFFFFFU;  // no run
  static constexpr std::uint32_t reading = nothing - 1;  // run_of_: read by this update

  // A triangle of a strip that is read. Triangles and edges are the exclusive or of their vertices. So the exclusive or
  // of a triangle and an edge is the third corner, in either direction of reading.
  struct Link {
    std::uint32_t triangle;
    std::uint32_t corners;
    std::uint32_t edge;  // to the next triangle
    std::uint32_t run;   // that it was in, or nothing
  };
  // Links begin … end of strip_, as a run.
  struct Text {
    std::uint32_t begin;
    std::uint32_t end;
    std::uint32_t first;  // in text_
    std::uint32_t length;
    std::uint32_t cuts;
    std::uint32_t place;   // of an old run that it takes, or nothing
    std::uint32_t across;  // neighbours of its triangles, in across_
    std::uint32_t across_end;
  };
  struct Neighbor {
    std::uint32_t place;
    std::uint32_t edges;  // in common
  };
  struct Slide {
    std::uint32_t cost = 0;
    std::uint32_t last = 0;
    std::uint32_t found = 0;  // cells
  };
  // A run seen from one of its ends.
  struct Start {
    const Link* link;
    std::ptrdiff_t step;                  // to the next link
    std::ptrdiff_t edge;                  // to the link that has the edge to the next triangle
    std::array<std::uint32_t, 3> corner;  // the last two are the ends of that edge
    bool swaps;                           // the second triangle repeats an index
  };

  void begin_reading() noexcept;
  void touch(std::uint32_t place);
  bool follow(const StripMesh& mesh, StripMesh::Halfedge in, std::uint32_t begin, std::uint32_t least,
              std::uint32_t edge_goes);
  void read(const StripMesh& mesh, std::uint32_t t);
  [[nodiscard]] std::uint32_t best_cut(std::uint32_t wanted, std::uint32_t begin) const noexcept;
  [[nodiscard]] Start start(const StripMesh& mesh, const Text& text, bool forward) const;
  [[nodiscard]] bool is_forward(const Text& text) const noexcept;
  void write_text(const StripMesh& mesh, std::uint32_t begin, std::uint32_t end, std::uint32_t cuts);
  void store();
  [[nodiscard]] bool store_in_place(const Text& text) noexcept;
  void store_in_gap(const Text& text) noexcept;
  void insert(const Text& text, std::uint32_t before) noexcept;
  [[nodiscard]] detail::Run as_run(const Text& text, std::uint32_t first) const noexcept;
  void own(const Text& text, std::uint32_t place) noexcept;
  void remove(std::uint32_t place) noexcept;
  void write(const Text& text, std::uint32_t first) noexcept;
  void blank(std::uint32_t first, std::uint32_t end) noexcept;
  void move(std::uint32_t place, std::uint32_t before, std::uint32_t first) noexcept;
  [[nodiscard]] Slide slide(std::uint32_t place, std::uint32_t missing, std::uint32_t most,
                            bool rightwards) const noexcept;
  std::uint32_t widen(std::uint32_t left, std::uint32_t right, std::uint32_t missing, std::uint32_t most) noexcept;
  void close_gaps() noexcept;
  void order_runs();
  void note_across(const StripMesh& mesh, std::uint32_t t);
  std::span<const Neighbor> neighbors(std::uint32_t begin, std::uint32_t end) noexcept;
  [[nodiscard]] std::uint32_t price_of_room(std::uint32_t before, std::uint32_t length,
                                            std::uint32_t most) const noexcept;
  [[nodiscard]] bool store_near(const Text& text) noexcept;
  void mark(std::size_t first, std::size_t end) noexcept;
  /// The index that fills gaps. For stitched strips any vertex will do: a gap draws only degenerate triangles.
  [[nodiscard]] std::uint32_t filling() const noexcept { return stitched_ ? 0 : cells_.restart(); }
  /// The length of the buffer: an even number of indices of 16 bits.
  [[nodiscard]] std::uint32_t even(std::uint32_t length) const noexcept {
    return cells_.narrow() ? length + length % 2 : length;
  }
  [[nodiscard]] std::span<const std::uint32_t> indices_of(const Text& text) const noexcept {
    return std::span(text_).subspan(text.first, text.length);
  }

  detail::Cells cells_{IndexWidth::bits32};
  std::vector<std::uint32_t> run_of_;  // by triangle: the place of its run
  detail::RunPlaces places_;
  bool stitched_ = false;
  LayoutOptions layout_;
  bool stale_ = true;     // an update was interrupted: the next one rewrites everything
  bool rebuilt_ = true;   // the last update rewrote everything
  bool returned_ = true;  // whether written_ has been returned
  std::vector<Range> written_;
  // The state of the current update.
  std::vector<std::uint32_t> dirty_;  // places whose runs are read
  std::vector<Link> strip_;
  std::uint32_t links_ = 0;  // the number in use of strip_
  std::vector<std::uint32_t> text_;
  std::uint32_t letters_ = 0;  // the number in use of text_
  std::vector<Text> texts_;
  std::vector<std::uint32_t> across_;  // triangles
  std::array<Neighbor, 40> neighbors_{};
  std::uint32_t slack_ = 0;    // indices that it may still slide for its runs, besides their share
  std::uint32_t changed_ = 0;  // indices of the runs read or written, whichever are more
};

}  // namespace restrip
