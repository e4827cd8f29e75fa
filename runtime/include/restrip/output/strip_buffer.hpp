// StripBuffer: an index buffer of strips that is kept in step with a mesh, rewriting only what changed.
//
// A renderer that draws strips while the level of detail changes should not have to rewrite its whole index buffer
// after every few operations. Here strips are cut into *runs* of at most 36 triangles, each in its place in the buffer.
// When triangles change, little more than their runs is written again.
//
//   std::vector<Triangle> changed;
//   mesh.watch(&changed);
//   StripBuffer buffer(mesh);                        // upload buffer.indices()
//   ... operations ...
//   for (const auto& range : buffer.update(mesh, changed)) upload(range);
//   changed.clear();
//
// Draw the whole buffer as one triangle strip with primitive restart (strips.hpp); without restart for
// StripForm::stitched. With StripForm::lengths draw the runs that draws() lists. Indices have 32 bits, or 16 with
// IndexWidth::bits16, for meshes whose vertices are numbered below 65,535. The mesh must number its triangles and
// vertices (mesh/mesh.hpp). triangle_list_buffer.hpp says when a triangle list is the better choice.
//
// How it works. An update follows the strips from the changed triangles to the ends of their runs and divides the
// triangles read into new runs. It prefers to cut where the strip repeats an index, which the cut saves. A new run
// takes the place of an old one, so that its beginning or its end stays where it is, and is written from the first
// index that differs to the last. A run that became longer uses the gaps next to its place; otherwise its neighbours
// slide, or it moves to the smallest gap that is large enough, or to the end of the buffer.
//
// Stitched runs. Each begins at an even index with its first vertex twice, is wound for an odd place, and ends with its
// last vertex repeated, to an even length. So the triangles between runs, or between a run and a gap filled with one
// vertex, are always degenerate, and stitched runs can move like others.
//
// Order. At first runs are in an order that a vertex cache likes (impl/run_order.hpp). A run that does not fit into its
// place any more is put in the cheapest room next to a run that shares its edges (impl/run_layout.hpp).
//
// Length. A cut takes three indices, less the repeated index that it saves, and the buffer has gaps. When cuts and gaps
// together exceed 9.5 % of the indices needed, an update moves the last runs into gaps, which it may widen. The buffer
// of a scanned mesh has some 1.09 times the indices of strip_indices() while it changes, also after scattered
// operations, a stitched one up to 1.25 times the indices of a stitched strip. Strips that
// repeat no index, such as strips of a grid, take more: one cut for every 28 triangles is already 11 %. A triangle list
// has 3 indices a triangle. Separating stitched runs takes two and a half indices, other runs one.
//
// Time. An update takes time linear in the changed triangles, except for sorting the ranges that it returns: it reads
// their runs and short adjacent runs, slides at most 60 indices for each run that grows, 150 and three for each index
// that needs another place, and moves five for each to close gaps. Only the growth of arrays is linear in the mesh;
// reserve() allocates the two largest in advance. Memory: 4 bytes a triangle, the indices, and 40 bytes a run.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <vector>

#include "restrip/mesh/mesh.hpp"
#include "restrip/output/impl/cells.hpp"
#include "restrip/output/impl/run_order.hpp"
#include "restrip/output/impl/run_places.hpp"
#include "restrip/output/strip_format.hpp"
#include "restrip/output/strips.hpp"
#include "restrip/precondition.hpp"

namespace restrip {

namespace detail {
class LiveState;

/// Sorts ranges, widens them to multiples of `unit` indices, cuts them off at `end`, and joins ranges that are at most
/// `gap` indices apart.
inline void join_ranges(std::vector<IndexRange>& ranges, std::size_t end, std::size_t gap, std::size_t unit) noexcept;

}  // namespace detail

class StripBuffer {
 public:
  using Range = IndexRange;

  /// Empty; the first update writes the whole buffer. `form`: any but a list. Throws std::invalid_argument if `layout`
  /// is out of range. `width`: 16 bits for IndexWidth::bits16, else 32.
  StripBuffer() = default;
  explicit StripBuffer(StripForm form, const LayoutOptions& layout = {}, IndexWidth width = IndexWidth::bits32)
      : cells_(width), stitched_(form == StripForm::stitched), layout_(layout) {
    RESTRIP_ASSERT(form != StripForm::list, "StripBuffer", "use TriangleListBuffer for triangle lists");
    if (!layout.in_range())
      RESTRIP_THROW(std::invalid_argument,
                    "restrip: LayoutOptions allow a cache of 64, a waste of 1,000,000 and a work of 100");
  }
  /// Writes the strips of a valid colouring. Linear time. Throws as rebuild() does.
  template <NumberedMesh Mesh>
  explicit StripBuffer(const Mesh& mesh, IndexWidth width = IndexWidth::bits32) : cells_(width) {
    rebuild(mesh);
  }

  /// Rewrites the whole buffer, without gaps. Triangles on solid cycles, which no valid colouring has, are left out.
  /// Throws std::length_error when a vertex number does not fit into an index (the restart index is not available), or
  /// std::bad_alloc, or what the mesh throws; then the buffer is incomplete, and the next update rewrites it.
  template <NumberedMesh Mesh>
  void rebuild(const Mesh& mesh);

  /// Brings the buffer in step with the mesh. `changed` names every triangle whose corners, neighbours or colours have
  /// changed since the last call, and every triangle inserted or removed, as StripMesh::watch does; repetitions do no
  /// harm. Returns the ranges whose indices may have changed, ascending and disjoint; the buffer may have grown or
  /// shrunk, by multiples of four bytes. Valid until the next call. Throws as rebuild() does. Then indices() is
  /// unchanged, unless the whole buffer was to be written, and the next update rewrites everything.
  template <NumberedMesh Mesh>
  std::span<const Range> update(const Mesh& mesh, std::span<const std::uint32_t> changed,
                                const RangeOptions& ranges = {});

  /// Makes the next update() also return the ranges of the last one, for a caller that has not uploaded them; the same
  /// for ranges that a BufferHistory has written.
  void keep_ranges() noexcept { returned_ = false; }

  /// The indices, if they have 32 or 16 bits; else empty. Between two runs, and in gaps, all bits are set.
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
  friend class BufferHistory;
  friend class detail::LiveState;

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
  template <class Mesh>
  bool follow(const Mesh& mesh, typename Mesh::Halfedge in, std::uint32_t begin, std::uint32_t least,
              std::uint32_t edge_goes);
  template <class Mesh>
  void read(const Mesh& mesh, std::uint32_t t);
  [[nodiscard]] std::uint32_t best_cut(std::uint32_t wanted, std::uint32_t begin) const noexcept;
  template <class Mesh>
  [[nodiscard]] Start start(const Mesh& mesh, const Text& text, bool forward) const;
  [[nodiscard]] bool is_forward(const Text& text) const noexcept;
  template <class Mesh>
  void write_text(const Mesh& mesh, std::uint32_t begin, std::uint32_t end, std::uint32_t cuts);
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
  // run_layout.hpp
  void order_runs();
  template <class Mesh>
  void note_across(const Mesh& mesh, std::uint32_t t);
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

#include "restrip/output/impl/run_layout.hpp"
#include "restrip/output/impl/strip_buffer.hpp"
