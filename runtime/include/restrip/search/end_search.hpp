// EndSearch: lowers the cost of a colouring by small changes at strip ends.
//
// A move begins at a triangle in which a strip ends (one with at most one solid edge). A dashed edge of it becomes
// solid:
//  - if a strip ends beyond it as well, the two strips are joined;
//  - otherwise the triangle beyond it loses one of its two solid edges. The triangle across that edge is a new end. So
//    an exchange moves an end, and changes the cost only by swaps.
// Nearly all moves that lower the cost are of these two kinds. In a well stripified mesh one triangle in ten is an end,
// so this examines a small part of what a Descent (descent.hpp) examines. The price of a move follows from at most ten
// triangles around it.
//
// If no single move lowers the cost, a chain may: each of its moves begins at the end that the previous move made. All
// ends are tried with one move before any is tried with two, and so on, until a limit on the work is reached. Walks
// along the strips test gainful moves for solid cycles.
//
//   EndSearch search(Cost::indices());
//   search.run(mesh, changed_triangles, {.looks = 10, .length = 4, .worse = 1});
//
// Everything is deterministic. Nothing is allocated, except for the list of changes of a watched mesh. The moves are
// the rotations of Pósa ("Hamiltonian circuits in random graphs", 1976) and the moves of tunnelling (Stewart,
// "Tunneling for triangle strips in continuous level-of-detail meshes", 2001), here with a price; chains of them are
// due to Lin and Kernighan (1973).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

#include "restrip/mesh/cost.hpp"
#include "restrip/search/descent.hpp"
#include "restrip/search/sided_mesh.hpp"

namespace restrip {

/// The limits of one call of EndSearch::run.
struct EndLimits {
  std::uint32_t looks = (std::numeric_limits<std::uint32_t>::max)();  ///< ends examined, with up to three dashed edges
  std::uint32_t length = 1;                                           ///< moves of a chain, at most max_length
  std::int32_t worse = 0;                                             ///< the highest rise of the cost within a chain
};

/// Sums over all calls.
struct EndCounts {
  std::uint64_t looked = 0;  ///< ends examined
  std::uint64_t priced = 0;  ///< adjacent edges whose moves were priced
  std::uint64_t made = 0;    ///< moves made and not undone
};

class EndSearch {
 public:
  using Halfedge = StripMesh::Halfedge;

  /// Limits on the moves of a chain and on the ends that one call remembers; further ends are ignored.
  static constexpr std::size_t max_length = 8;
  static constexpr std::size_t max_ends = 64;

  explicit EndSearch(Cost cost = Cost::indices()) noexcept : cost_(cost) {}

  /// Begins at the ends among the given triangles, and at ends across a dashed edge of the others. The triangles must
  /// be alive; some may be named twice. The mesh must have a valid colouring. Returns the changes in counts; the cost
  /// never rises.
  ///
  /// Throws std::bad_alloc only while the mesh is watched; the colouring is valid then, but changes are not reported.
  ColoringChange run(SidedMesh auto& mesh, std::span<const Triangle> from, const EndLimits& limits = {});

  /// The moves that begin at an end and whose price is at most `highest`, in a fixed order, without a test for cycles.
  /// At most six. Constant time. `given_up` is {none} and the edge that the triangle beyond loses, if any.
  [[nodiscard]] std::span<const StripMove> moves_at(const SidedMesh auto& mesh, Triangle end, std::int32_t highest);

  [[nodiscard]] const Cost& cost() const noexcept { return cost_; }
  [[nodiscard]] const EndCounts& counts() const noexcept { return counts_; }
  /// The number of triangles walked past to find cycles.
  [[nodiscard]] std::uint64_t walked() const noexcept { return walks_.counts().walked; }

 private:
  static constexpr std::uint32_t done_with = max_length + 1;

  /// An end to examine, and the length of the chains that have been tried there.
  struct End {
    Triangle triangle;
    std::uint32_t tried;
  };
  using Found = detail::FoundMoves;

  void find_moves(const SidedMesh auto& mesh, Triangle end, std::int32_t highest, Found& found);
  void look_later(Triangle end) noexcept;
  void consider(const SidedMesh auto& mesh, Triangle t) noexcept;
  [[nodiscard]] bool chain(SidedMesh auto& mesh, Triangle end, std::size_t made, std::int32_t price, std::size_t length,
                           const EndLimits& limits);
  void make(SidedMesh auto& mesh, const StripMove& move);

  Cost cost_;
  EndCounts counts_;
  Descent walks_;
  ColoringChange done_;
  std::uint64_t last_look_ = 0;
  std::array<End, max_ends> ends_{};
  std::size_t end_count_ = 0;
  std::array<StripMove, max_length> chain_{};
  Found found_;
};

}  // namespace restrip

#include "restrip/search/impl/end_search.hpp"
