// StripBuffer: an index buffer of strips that is kept in step with a mesh, rewriting only what changed.
//
// A renderer that draws strips while the level of detail moves does not want to write its whole index buffer again
// after every few operations. Here strips are cut into *runs* of at most 36 triangles, each in a place of its own. When
// triangles change, the runs that they are in are written again, and little else.
//
//   std::vector<Triangle> changed;
//   mesh.watch(&changed);
//   StripBuffer buffer(mesh);                        // upload buffer.indices()
//   ... operations ...
//   for (const auto& range : buffer.update(mesh, changed)) upload(range);
//   changed.clear();
//
// Draw the whole buffer as one triangle strip with primitive restart (strips.hpp), or, when it was made with
// StripForm::stitched, without; with StripForm::lengths draw the runs that draws() lists. StripBuffer has 32-bit
// indices, StripBuffer16 has 16-bit ones, for meshes whose vertices are numbered below 65,535. Any mesh will do that
// numbers its triangles and vertices (mesh/numbered_mesh.hpp). When a triangle list is the better choice:
// triangle_list_buffer.hpp.
//
// How it works. An update follows the strips from the triangles that changed to the ends of their runs and divides what
// it has read into new runs. It cuts where the strip repeats an index, which the cut saves. A new run takes the place
// of an old one, so that its beginning or its end stays where it is, and is written from the first index that differs
// to the last. A run that became longer uses the gaps beside its place; otherwise its neighbours slide, or it moves to
// the smallest gap that is large enough, or to the end of the buffer.
//
// Stitched runs. Each begins at an even index with its first vertex twice, is wound for an odd place, and ends with its
// last vertex repeated, to an even length. So whatever lies before and behind it, other runs or gaps filled with one
// vertex, what leads from one to the other is degenerate, and runs move as others do.
//
// Length. A cut takes three indices, less those that it saves, and there are gaps. Where cuts and gaps together exceed
// 9 % of the indices needed, an update moves the last runs into gaps, which it may widen. The buffer of a scanned mesh
// has some 1.09 times the indices of strip_indices(), at coarse levels up to 1.13 times. Strips that repeat no index,
// such as those of a grid, take more: one cut for every 28 triangles is 11 % already. A triangle list has 3 indices a
// triangle. A stitched run takes two indices and a half where another takes one.
//
// Time. An update takes time linear in the triangles that changed, but for sorting the ranges that it returns: it reads
// the runs that they are in and short runs that join them, slides at most 60 indices for each run that grows, and moves
// at most some 600 to close gaps. No update takes time linear in the mesh, but for the growth of its arrays, which
// reserve() takes beforehand for the two largest. Memory: 4 bytes a triangle, the indices, and 40 bytes a run.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <type_traits>
#include <vector>

#include "restrip/mesh/numbered_mesh.hpp"
#include "restrip/output/impl/run_places.hpp"
#include "restrip/output/strip_format.hpp"
#include "restrip/output/strips.hpp"
#include "restrip/precondition.hpp"

namespace restrip {

namespace detail {

/// Sorts ranges, widens them to multiples of `unit` indices, cuts them off at `end`, and joins those that are at most
/// `gap` indices apart.
inline void join_ranges(std::vector<IndexRange>& ranges, std::size_t end, std::size_t gap, std::size_t unit) noexcept;

}  // namespace detail

/// `Index`: an unsigned type of 16 or 32 bits.
template <class Index>
class BasicStripBuffer {
 public:
  static_assert(std::is_same_v<Index, std::uint16_t> || std::is_same_v<Index, std::uint32_t>);
  using Range = IndexRange;
  /// The index between two runs, and in gaps: all bits set, as graphics interfaces have it.
  static constexpr Index restart = std::numeric_limits<Index>::max();

  /// Empty; the first update writes it as a whole. `form`: any but a list.
  BasicStripBuffer() = default;
  explicit BasicStripBuffer(StripForm form) noexcept : stitched_(form == StripForm::stitched) {
    RESTRIP_ASSERT(form != StripForm::list, "StripBuffer", "a list is the matter of TriangleListBuffer");
  }
  /// Writes the strips of a valid colouring. Linear time. Throws as rebuild() does.
  template <NumberedMesh Mesh>
  explicit BasicStripBuffer(const Mesh& mesh) {
    rebuild(mesh);
  }

  /// Writes everything again, without gaps. Triangles on solid cycles, which no valid colouring has, are left out.
  /// Throws std::length_error when the number of a vertex does not fit into an index (the restart index is none), or
  /// std::bad_alloc, or what the mesh throws; then the buffer is incomplete, and the next update writes it again.
  template <NumberedMesh Mesh>
  void rebuild(const Mesh& mesh);

  /// Brings the buffer in step with the mesh. `changed` names every triangle whose corners, neighbours or colours have
  /// changed since the last call, and those inserted and removed, as StripMesh::watch does; repetitions do no harm.
  /// Returns the ranges whose indices may have changed, ascending and apart from each other; the buffer may have grown
  /// or shrunk, by multiples of four bytes. Valid until the next call. Throws as rebuild() does; then indices() is as
  /// it was before, unless everything was to be written, and the next update writes everything again.
  template <NumberedMesh Mesh>
  std::span<const Range> update(const Mesh& mesh, std::span<const std::uint32_t> changed,
                                const RangeOptions& ranges = {});

  /// Makes the next update() return the ranges of the last one again, besides its own, for a caller that has not
  /// uploaded them; the same for ranges that a BufferHistory has written.
  void keep_ranges() noexcept { told_ = false; }

  [[nodiscard]] std::span<const Index> indices() const noexcept { return cells_; }
  /// The runs in the order of the buffer, without what separates them: for a multi-draw without restart. Linear in the
  /// runs. `draws` is overwritten.
  void draws(std::vector<Range>& draws) const;
  /// Number of runs.
  [[nodiscard]] std::size_t runs() const noexcept { return places_.runs(); }
  /// Indices that draw runs, what separates them included; the rest of the buffer is gaps.
  [[nodiscard]] std::size_t used() const noexcept { return places_.used(); }
  /// Room for a mesh of this many triangle numbers, at 2 indices each.
  void reserve(std::size_t triangles) {
    run_of_.reserve(triangles);
    cells_.reserve(2 * triangles);
  }

 private:
  template <class>
  friend class BasicBufferHistory;

  using State = detail::RunPlaces::State;
  static constexpr std::uint32_t nothing = 0xFFFFFFFFU;  // no run
  static constexpr std::uint32_t reading = nothing - 1;  // run_of_: read by this update

  // A triangle of a strip that is read. Triangles and edges are the exclusive or of their vertices: less an edge, a
  // triangle is the third corner, from whichever side the strip is read.
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
    std::uint32_t place;  // of an old run that it takes, or nothing
  };
  // A run seen from one of its ends.
  struct Start {
    const Link* link;
    std::ptrdiff_t step;                  // to the next link
    std::ptrdiff_t edge;                  // to the link that has the edge to the next triangle
    std::array<std::uint32_t, 3> corner;  // the last two are those of that edge
    bool swaps;                           // the second triangle repeats an index
  };

  void begin_reading() noexcept;
  void touch(std::uint32_t place);
  template <class Mesh>
  bool follow(const Mesh& mesh, typename Mesh::Halfedge in, std::uint32_t begin, std::uint32_t least,
              std::uint32_t edge_goes);
  template <class Mesh>
  void read(const Mesh& mesh, std::uint32_t t);
  [[nodiscard]] std::uint32_t best_cut(std::uint32_t near, std::uint32_t begin) const noexcept;
  template <class Mesh>
  [[nodiscard]] Start start(const Mesh& mesh, const Text& text, bool forward) const;
  [[nodiscard]] bool is_forward(const Text& text) const noexcept;
  template <class Mesh>
  void write_text(const Mesh& mesh, std::uint32_t begin, std::uint32_t end, std::uint32_t cuts);
  void prepare();
  void store() noexcept;
  [[nodiscard]] bool store_in_place(const Text& text) noexcept;
  void store_anew(const Text& text) noexcept;
  void own(const Text& text, std::uint32_t place) noexcept;
  void remove(std::uint32_t place) noexcept;
  void write(const Text& text, std::uint32_t first) noexcept;
  void blank(std::uint32_t first, std::uint32_t end) noexcept;
  void move(std::uint32_t place, std::uint32_t before, std::uint32_t first) noexcept;
  std::uint32_t widen(std::uint32_t left, std::uint32_t right, std::uint32_t missing, std::uint32_t most) noexcept;
  void close_gaps() noexcept;
  void mark(std::size_t first, std::size_t end) noexcept;
  /// What fills gaps. Of stitched strips any vertex will do: all that a gap draws is degenerate.
  [[nodiscard]] Index filling() const noexcept { return stitched_ ? Index{0} : restart; }
  /// A buffer that is long enough: an even number of indices of 16 bits.
  [[nodiscard]] static std::uint32_t even(std::uint32_t length) noexcept {
    return sizeof(Index) == 2 ? length + length % 2 : length;
  }

  std::vector<Index> cells_;
  std::vector<std::uint32_t> run_of_;  // by triangle: the place of its run
  detail::RunPlaces places_;
  bool stitched_ = false;
  bool stale_ = true;    // an update was interrupted: the next one writes everything again
  bool rebuilt_ = true;  // the last one did
  bool told_ = true;     // what is in written_
  std::vector<Range> written_;
  // What the current update works on.
  std::vector<std::uint32_t> dirty_;  // places whose runs are read
  std::vector<Link> strip_;
  std::uint32_t links_ = 0;  // so many of strip_
  std::vector<Index> text_;
  std::uint32_t letters_ = 0;  // so many of text_
  std::vector<Text> texts_;
};

using StripBuffer = BasicStripBuffer<std::uint32_t>;
using StripBuffer16 = BasicStripBuffer<std::uint16_t>;

}  // namespace restrip

#include "restrip/output/impl/strip_buffer.hpp"
#include "restrip/output/impl/strip_buffer_store.hpp"
