// EndSearch: fewer indices (or whatever a Cost counts) by small changes at the ends of strips.
//
// A move begins at a triangle in which a strip ends (one with at most one solid edge). A dashed edge of it becomes
// solid:
//  - if a strip ends behind it as well, the two strips are joined;
//  - otherwise the triangle behind it gives one of its two solid edges up. The triangle behind that edge is a new end,
//    so that an exchange moves an end, and the cost changes by swaps alone.
// Nearly all moves that pay are of these two kinds, and where a mesh is well stripified one triangle in ten is an end:
// this is a small part of what a Descent (descent.hpp) looks at. The price of a move follows from at most ten triangles
// around it.
//
// Where no single move pays, a chain may: each of its moves begins at the end that the move before has made. All ends
// are tried with one move before any is tried with two, and so on, until a limit on the work is reached. Whether moves
// close solid cycles is found by walking along the strips, and only when the moves pay.
//
//   EndSearch search(Cost::indices());
//   search.run(mesh, changed_triangles, {.looks = 10, .length = 4, .worse = 1});
//
// Everything is deterministic. Nothing is allocated, but for what a watched mesh reports. The moves are the rotations
// of Pósa ("Hamiltonian circuits in random graphs", 1976), and those by which strips are tunnelled (Stewart, "Tunneling
// for triangle strips in continuous level-of-detail meshes", 2001), here with a price; chains of them are due to Lin
// and Kernighan (1973).
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

/// What one call of EndSearch::run may do.
struct EndLimits {
  std::uint32_t looks = std::numeric_limits<std::uint32_t>::max();  ///< at ends, each at up to three dashed edges
  std::uint32_t length = 1;                                         ///< moves of a chain, at most max_length
  std::int32_t worse = 0;  ///< how much the cost may have risen in the middle of a chain
};

/// Sums over all calls.
struct EndCounts {
  std::uint64_t looked = 0;  ///< ends looked at
  std::uint64_t priced = 0;  ///< adjacent edges whose moves were priced
  std::uint64_t made = 0;    ///< moves made for good
};

class EndSearch {
 public:
  using Halfedge = StripMesh::Halfedge;

  /// Moves of a chain, and ends that one call keeps in mind; further ends are not looked at.
  static constexpr std::size_t max_length = 8;
  static constexpr std::size_t max_ends = 64;

  explicit EndSearch(Cost cost = Cost::indices()) noexcept : cost_(cost) {}

  /// Begins at the ends among the triangles given, and at those across a dashed edge of the other ones. The triangles
  /// must be alive, some may be named twice. The mesh must have a valid colouring. Returns what has changed; the cost
  /// never rises.
  ///
  /// Throws std::bad_alloc only while the mesh is watched; the colouring is valid then, and what has changed is lost.
  template <SidedMesh Mesh>
  ColoringChange run(Mesh& mesh, std::span<const Triangle> from, const EndLimits& limits = {});

  /// The moves that begin at an end and whose price is at most `highest`, cycles not looked for, in a fixed order. At
  /// most six. Constant time. `given_up` is {none} and the edge that the triangle behind gives up, if it does.
  template <SidedMesh Mesh>
  [[nodiscard]] std::span<const StripMove> moves_at(const Mesh& mesh, Triangle end, std::int32_t highest);

  [[nodiscard]] const Cost& cost() const noexcept { return cost_; }
  [[nodiscard]] const EndCounts& counts() const noexcept { return counts_; }
  /// Triangles walked past to find cycles.
  [[nodiscard]] std::uint64_t walked() const noexcept { return walks_.counts().walked; }

 private:
  static constexpr std::uint32_t done_with = max_length + 1;

  /// An end that is to be looked at, and the length of the chains that have been tried there.
  struct End {
    Triangle triangle;
    std::uint32_t tried;
  };
  using Found = detail::FoundMoves;
  /// The end of a strip, as its neighbours see it.
  struct Tip;

  template <SidedMesh Mesh>
  void find_moves(const Mesh& mesh, Triangle end, std::int32_t highest, Found& found);
  template <SidedMesh Mesh>
  void find_joint(const Mesh& mesh, const Tip& tip, Halfedge back, std::int32_t highest, Found& found) const;
  template <SidedMesh Mesh>
  void find_exchanges(const Mesh& mesh, const Tip& tip, Halfedge back, std::int32_t highest, Found& found) const;
  void look_later(Triangle end) noexcept;
  template <SidedMesh Mesh>
  void consider(const Mesh& mesh, Triangle t) noexcept;
  template <SidedMesh Mesh>
  [[nodiscard]] bool pass(Mesh& mesh, std::uint32_t length, const EndLimits& limits);
  template <SidedMesh Mesh>
  void step(Mesh& mesh, Triangle end);
  template <SidedMesh Mesh>
  [[nodiscard]] bool chain(Mesh& mesh, Triangle end, std::size_t made, std::int32_t price, std::size_t length,
                           const EndLimits& limits);
  template <SidedMesh Mesh>
  [[nodiscard]] bool make_chain(Mesh& mesh, std::size_t length);
  template <SidedMesh Mesh>
  void make(Mesh& mesh, const StripMove& move);

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
