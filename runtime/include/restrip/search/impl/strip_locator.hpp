// StripLocator: finds whether two triangles are in one strip, and their order, without walking it, while strips are
// cut, linked, reversed and rewritten.
//
// A strip is a list of *chunks* of at most `chunk_limit` triangles. A triangle knows its chunk and a label that grows
// along the chunk; a chunk knows its strip, its rank and its direction (impl/chunk_lists.hpp). This is the two-level
// list of the travelling-salesman codes (Fredman, Johnson, McGeoch, Ostheimer, "Data structures for traveling
// salesmen", 1995).
//
// Costs, for a strip of n triangles: position() two memory reads; cut and link O(chunk_limit + n / chunk_limit), for
// the smaller part, and link occasionally renews the ranks of the larger part, amortised O(1) for each chunk of the
// smaller one; a local rewrite O(triangles of the patch), one cut for each strip that it cuts, and, amortised,
// O(chunk_limit) for each chunk whose labels run out and O(log n) for each chunk added when one has grown too large.
// The default limit is made for strips of a few hundred triangles; for longer strips about half the square root of n is
// best. Memory: 12 bytes a triangle and about one byte for chunks. Nothing is allocated once the arrays have grown.
// After an exception (std::bad_alloc) of any function the mesh's colouring is valid, and the locator must be rebuilt.
//
// The locator walks solid edges of the mesh when it splits or renumbers a chunk, so colours and locator must change
// together. Colour dual edges through cut() and link(), and call before_patch() before every local operation and
// after_patch() after it.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "restrip/search/impl/chunk_lists.hpp"
#include "restrip/search/sided_mesh.hpp"

namespace restrip {

class StripLocator {
 public:
  using Halfedge = StripMesh::Halfedge;

  /// The position of a triangle: two triangles are in the same strip if `strip` is equal, and then `order` grows along
  /// it. Names and orders are valid until the next change; the direction of counting is arbitrary.
  struct Position {
    std::uint32_t strip = none;
    std::uint64_t order = 0;
    friend constexpr bool operator==(const Position&, const Position&) = default;
  };

  static constexpr std::uint32_t default_chunk_limit = 64;
  /// The limit for a mesh whose strips are to become as long as the mesh allows.
  [[nodiscard]] static std::uint32_t chunk_limit_for_long_strips(std::size_t triangles) noexcept {
    return std::clamp(static_cast<std::uint32_t>(std::sqrt(static_cast<double>(triangles)) / 2), default_chunk_limit,
                      room_for_labels);
  }

  /// Chunks hold at most `chunk_limit` triangles, clamped to 8 … 1024.
  explicit StripLocator(std::uint32_t chunk_limit = default_chunk_limit)
      : chunk_limit_(std::clamp(chunk_limit, 8U, room_for_labels)) {}
  /// Reads a valid colouring; throws std::invalid_argument when it is not. Linear time.
  explicit StripLocator(const SidedMesh auto& mesh, std::uint32_t chunk_limit = default_chunk_limit)
      : StripLocator(chunk_limit) {
    rebuild(mesh);
  }
  /// Reads the whole colouring again, as the constructor does. After an exception the locator must not be used until
  /// rebuild() succeeds.
  void rebuild(const SidedMesh auto& mesh);

  /// False if the locator does not know a triangle, because the mesh was changed without it.
  [[nodiscard]] bool knows(Triangle t) const noexcept { return t < addresses_.size() && addresses_[t].chunk != none; }
  /// The position of a triangle that is alive.
  [[nodiscard]] Position position(Triangle t) const noexcept {
    RESTRIP_ASSERT(knows(t), "StripLocator::position", "the locator does not know the triangle");
    const Address address = addresses_[t];
    const auto& chunk = lists_[address.chunk];
    const Label label = chunk.backwards ? ~address.label : address.label;
    return {chunk.list, std::uint64_t{chunk.rank} << 32 | label};
  }
  /// Number of strips.
  [[nodiscard]] std::size_t strips() const noexcept { return lists_.lists(); }

  // Preconditions are checked in debug builds (precondition.hpp).

  /// Makes the solid dual edge of h dashed.
  void cut(SidedMesh auto& mesh, Halfedge h);
  /// Makes the dashed dual edge of h solid. Both its triangles must be ends, of different strips.
  void link(SidedMesh auto& mesh, Halfedge h);

  /// A local rewrite, in three steps: before_patch with the triangles about to be rewritten, the rewrite, after_patch
  /// with the new triangles. Colours outside, and of the dual edges between outside and patch, may only change from
  /// solid to dashed, and solid paths through the patch may only join dual edges into it that were joined before
  /// (docs/explanation/theory.md: P' is part of P; every rule of operations.hpp is of this kind).
  void before_patch(const SidedMesh auto& mesh, std::span<const Triangle> patch);
  void after_patch(const SidedMesh auto& mesh, std::span<const Triangle> patch);

  /// Makes room for this many triangles, so that operations up to there do not allocate.
  void reserve(std::size_t triangles) {
    addresses_.reserve(triangles);
    marks_.reserve(triangles);
    lists_.reserve(triangles / 16, triangles / 16);
  }

 private:
  using Label = std::uint32_t;
  using ChunkId = detail::ChunkLists::Id;
  static constexpr Label middle_label = 1U << 31;
  static constexpr Label label_step = 1U << 21;
  static constexpr std::uint32_t room_for_labels = middle_label / label_step;  // in one chunk

  struct Address {
    ChunkId chunk = none;
    Label label = 0;
  };
  /// A solid path inside a patch: the halfedges that lead into it from outside, {none} at a strip's end.
  struct Strand {
    Halfedge in{};
    Halfedge out{};
    bool up_in = false;  // labels grow across `in`, from the outside triangle into the patch
    bool up_out = false;
    bool passes = false;      // before the rewrite: it still leads from `in` to `out` after it
    bool pending = false;     // before the rewrite: its triangles have no address at the moment
    std::uint32_t first = 0;  // its triangles in strand_nodes_
    std::uint32_t last = 0;
  };

  /// An `in` or `out` of a strand before the rewrite. An outside triangle has at most two; marks_ leads to the first.
  struct End {
    Halfedge at{};
    std::uint32_t strand = 0;
    std::uint32_t other = none;  // in ends_
  };

  // ---- chunks and their labels
  bool step(const SidedMesh auto& mesh, Triangle& t, unsigned& entry) const noexcept;
  [[nodiscard]] bool labels_grow(const SidedMesh auto& mesh, Halfedge h) const noexcept;
  [[nodiscard]] bool is_last(const SidedMesh auto& mesh, Triangle end) const noexcept;
  void renumber(const SidedMesh auto& mesh, Halfedge h, bool up);
  [[nodiscard]] bool append(Halfedge h, bool up, std::span<const Triangle> nodes);
  void separate(const SidedMesh auto& mesh, Halfedge a, bool up_a, Halfedge b);
  void move_to(ChunkId to, ChunkId from, std::span<const Triangle> nodes) noexcept;
  void divide(const SidedMesh auto& mesh, Triangle member);

  // ---- patches
  void find_strands(const SidedMesh auto& mesh, std::span<const Triangle> patch, std::vector<Strand>& strands);
  [[nodiscard]] Strand* strand_at(Halfedge h) noexcept;
  void place_strand(const Strand& strand);
  void renumber_later(Halfedge h, bool up);

  std::vector<Address> addresses_;
  detail::ChunkLists lists_;
  std::uint32_t chunk_limit_;
  std::vector<Triangle> moving_;
  std::vector<Triangle> renumbered_;
  std::vector<std::uint32_t> marks_;  // of a patch and its ends: values above the ones of all earlier patches
  std::uint32_t mark_ = 0;
  std::uint32_t first_end_ = 0;  // marks_ of the triangle of ends_[i] is first_end_ + i, for the first of a triangle
  std::vector<Strand> strands_before_;
  std::vector<Strand> strands_after_;
  std::vector<End> ends_;
  std::size_t pending_ = 0;  // number of strands that are
  std::vector<std::pair<Halfedge, bool>> crowded_;
  std::vector<Triangle> strand_nodes_;
  std::vector<ChunkId> touched_;
};

}  // namespace restrip

#include "restrip/search/impl/strip_locator_sides.hpp"
