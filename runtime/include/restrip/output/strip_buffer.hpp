// StripBuffer: an index buffer of strips that is kept in step with a mesh, rewriting only what changed.
//
// A renderer that draws strips while the level of detail moves does not want to write its whole index buffer again
// after every few operations. Here each strip is a *run* of indices in a place of its own; when triangles change, the
// runs they are in are patched where they are, and little else is written.
//
//   std::vector<Triangle> changed;
//   mesh.watch(&changed);
//   StripBuffer buffer(mesh);                        // upload buffer.indices()
//   ... operations ...
//   for (const auto& range : buffer.update(mesh, changed)) upload(range);
//   changed.clear();
//
// Draw the whole buffer as one triangle strip with primitive restart (strips.hpp). StripBuffer has 32-bit indices,
// StripBuffer16 has 16-bit ones, for meshes whose vertices are numbered below 65,535. Any mesh will do that numbers its
// triangles and vertices (mesh/numbered_mesh.hpp). When a triangle list is the better choice: triangle_list_buffer.hpp.
//
// How it works. What stays of a run is copied as it is, in either direction; between two such stretches the new
// triangles are written, and one index is repeated where the order of the two indices at the seam is the wrong one. A
// text that became shorter may be filled up with repeated indices, which draw degenerate triangles, so that the rest of
// the run stays where it is. A text that became longer takes the gap behind or before its place, or its neighbours
// slide, or it moves to a gap that is large enough, or to the end. Strips longer than 200 indices are several runs.
//
// Length. Gaps, repeated indices and divided strips waste indices. Where they waste more than 8 % of the indices that
// the strips need, an update also closes gaps: runs from the end of the buffer go into gaps, neighbours slide together.
// So after each update indices().size() is at most 1.10 times the indices that strip_indices() writes, and 128 more. A
// triangle list has 3 indices a triangle: strips stay below that where they need less than 2.7.
//
// Time. An update takes time linear in the triangles that changed and in the runs they are in, 200 indices each at
// most. Closing gaps writes at most 160 indices and 4 for each index that was written before, and looks at no more than
// 64 runs and one for four indices of these runs. No update takes time linear in the mesh, but for the growth of its
// arrays, which reserve() takes beforehand. Memory: 8 bytes a triangle, 4 an index besides the index itself, 36 a run.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "restrip/mesh/numbered_mesh.hpp"
#include "restrip/output/impl/run_places.hpp"

namespace restrip {

/// Some consecutive indices of a buffer.
struct IndexRange {
  std::size_t first = 0;
  std::size_t count = 0;
  friend constexpr bool operator==(const IndexRange&, const IndexRange&) = default;
};

/// `Index`: an unsigned type of 16 or 32 bits.
template <class Index>
class BasicStripBuffer {
 public:
  static_assert(std::is_same_v<Index, std::uint16_t> || std::is_same_v<Index, std::uint32_t>);
  using Range = IndexRange;
  /// The index between two runs, and in gaps: all bits set, as graphics interfaces have it.
  static constexpr Index restart = std::numeric_limits<Index>::max();

  /// Empty; the first update writes it as a whole.
  BasicStripBuffer() = default;
  /// Writes the strips of a valid colouring. Linear time. Throws as rebuild() does.
  template <NumberedMesh Mesh>
  explicit BasicStripBuffer(const Mesh& mesh) {
    rebuild(mesh);
  }

  /// Writes everything anew, without gaps. Triangles on solid cycles, which no valid colouring has, are left out.
  /// Throws std::length_error when the number of a vertex does not fit into an index (the restart index is none), or
  /// std::bad_alloc, or what the mesh throws; then the buffer is incomplete, and the next update writes it anew.
  template <NumberedMesh Mesh>
  void rebuild(const Mesh& mesh);

  /// Brings the buffer in step with the mesh. `changed` names every triangle whose corners, neighbours or colours have
  /// changed since the last call, and those inserted and removed, as StripMesh::watch does; repetitions do no harm.
  /// Returns the ranges whose indices may have changed, ascending and apart from each other; the buffer may have grown
  /// or shrunk. Valid until the next call. Throws as rebuild() does; then indices() is as it was before, and the next
  /// update writes everything anew.
  template <NumberedMesh Mesh>
  std::span<const Range> update(const Mesh& mesh, std::span<const std::uint32_t> changed);

  [[nodiscard]] std::span<const Index> indices() const noexcept { return cells_; }
  /// Number of runs.
  [[nodiscard]] std::size_t runs() const noexcept { return places_.runs(); }
  /// Indices that draw runs, the restart index behind each included; the rest of the buffer is gaps and repeated
  /// indices that could go.
  [[nodiscard]] std::size_t used() const noexcept { return places_.used() - places_.pads(); }
  /// Room for a mesh of this many triangle numbers, at 2 indices each.
  void reserve(std::size_t triangles);

 private:
  static constexpr std::uint32_t nothing = 0xFFFFFFFFU;  // no triangle, no place
  static constexpr std::uint32_t gone = nothing - 1;     // whose: a triangle that is to be written anew
  static constexpr std::uint32_t pending = nothing - 1;  // At::place: is being written anew

  struct At {
    std::uint32_t place = nothing;
    std::uint32_t offset = 0;  // of the index that completes the triangle
  };
  // A part of a strip: a triangle, or a stretch of a run that stays as it is.
  struct Piece {
    std::array<std::uint32_t, 3> corner{};  // counter-clockwise
    std::uint32_t triangle = nothing;       // nothing: a stretch
    std::uint8_t enters = 3;                // the corner opposite to the edge over which the strip comes, 3: it begins
    std::uint8_t leaves = 3;
    bool forward = true;
    std::uint32_t place = 0;
    std::uint32_t from = 0;
    std::uint32_t to = 0;
    std::uint32_t pads = 0;
  };
  // A run to be stored.
  struct Fresh {
    std::uint32_t begin = 0;  // in text_
    std::uint32_t length = 0;
    std::uint32_t pads = 0;
    std::uint32_t cuts = 0;          // its ends where the strip goes on
    std::uint32_t target = nothing;  // the place that most of it comes from
    std::uint32_t wish = 0;          // where it should begin, so that this stays where it is
    bool aligned = false;            // wish is known
    // Two stretches of that place, so many indices apart from what they were.
    std::uint32_t head = 0;
    std::uint32_t tail = 0;
    std::uint32_t shift = 0;
  };

  void forget(std::uint32_t t);
  void touch(std::uint32_t place);
  template <class Mesh>
  void collect(const Mesh& mesh, std::uint32_t start);
  template <class Mesh>
  void follow(const Mesh& mesh, typename Mesh::Halfedge in);
  static std::uint32_t pads_within(const std::uint32_t* whose, std::uint32_t from, std::uint32_t to) noexcept;
  template <class Mesh>
  Piece load(const Mesh& mesh, typename Mesh::Halfedge in) const;
  void assemble();
  void emit(std::size_t begin, std::size_t end);
  void generate(std::size_t begin, std::size_t end, std::uint32_t target);
  void append(const Piece& piece, bool leaves);
  void append_stretch(Piece piece, std::uint32_t target, bool squeeze, std::uint32_t& may_pad);
  void put(Index cell, std::uint32_t whose) {
    text_.push_back(cell);
    names_.push_back(whose);
  }
  static void flip(Piece& piece) noexcept {
    std::swap(piece.enters, piece.leaves);
    piece.forward = !piece.forward;
  }
  static constexpr std::uint32_t is_cut(std::uint8_t side, bool divided) noexcept {
    return side != 3 || divided ? 1 : 0;
  }
  static constexpr std::size_t weight(const Piece& piece) noexcept {
    return piece.triangle != nothing ? 6 : 4 * (piece.to - piece.from + 1);
  }
  void prepare();
  void store() noexcept;
  void store_in_place(std::size_t begin, std::size_t end) noexcept;
  bool make_room(std::uint32_t p, std::uint32_t cells) noexcept;
  void place_anew(const Fresh& fresh) noexcept;
  void write(std::uint32_t p, std::uint32_t first, const Fresh& fresh, bool all) noexcept;
  void blank(std::uint32_t first, std::uint32_t end) noexcept;
  void slide(std::uint32_t p, std::uint32_t first) noexcept;
  void remove(std::uint32_t p) noexcept;
  void mark(std::size_t first, std::size_t end) noexcept;
  void compact() noexcept;
  std::size_t move_from_the_end(std::size_t budget) noexcept;
  void slide_together(std::uint32_t p) noexcept;
  void move(std::uint32_t p, std::uint32_t before) noexcept;
  void trim() noexcept;
  void merge_ranges() noexcept;

  std::vector<Index> cells_;
  std::vector<std::uint32_t> whose_;  // by cell: the triangle that it completes
  std::vector<At> at_;                // by triangle
  detail::RunPlaces places_;
  std::uint32_t cursor_ = 0;  // compaction goes on behind this place
  bool stale_ = true;         // an update was interrupted: the next one writes everything anew
  std::vector<Range> written_;
  std::size_t marked_ = 0;  // indices written so far
  // What the current update works on.
  std::vector<std::uint32_t> touched_;
  std::vector<Piece> pieces_;
  std::vector<Fresh> fresh_;
  std::vector<Fresh> homeless_;
  std::vector<Index> text_;
  std::vector<std::uint32_t> names_;
  std::size_t begin_ = 0;       // of the run that is being written, in text_
  std::size_t most_steps_ = 0;  // of this compaction
  std::size_t seen_ = 0;        // about how many indices the strip has so far
};

using StripBuffer = BasicStripBuffer<std::uint32_t>;
using StripBuffer16 = BasicStripBuffer<std::uint16_t>;

}  // namespace restrip

#include "restrip/output/impl/strip_buffer.hpp"
#include "restrip/output/impl/strip_buffer_compact.hpp"
#include "restrip/output/impl/strip_buffer_store.hpp"
#include "restrip/output/impl/strip_buffer_text.hpp"
