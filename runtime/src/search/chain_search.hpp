// ChainSearch: lowers the cost of a colouring by chains of moves at strip ends.
//
//   ChainSearch search(Cost::indices());
//   search.run(mesh, changed_triangles, {.looks = 12, .length = 8, .worse = 1});
//
// chain_search.cpp tells the method. Everything is deterministic. Memory: 4 bytes a triangle; nothing else is allocated
// once the arrays have grown.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "restrip/mesh/cost.hpp"
#include "restrip/mesh/strip_mesh.hpp"
#include "restrip/search/policy.hpp"
#include "search/poll.hpp"

namespace restrip {

/// `edge`, dashed, at a strip end becomes solid. If the triangle across it has two solid edges, `cut` becomes dashed.
struct ChainMove {
  StripMesh::Halfedge edge{};  ///< a side of the end; {none}: a strip is cut, and a chain begins
  StripMesh::Halfedge cut{};   ///< a side of the new end; {none}: two strips are joined
  ColoringChange change{};
  std::int32_t price = 0;  ///< of that change
  [[nodiscard]] bool only_cuts() const noexcept { return edge.id == none; }
  [[nodiscard]] bool joins() const noexcept { return cut.id == none; }
  /// Where the strip ends after a move that does not join.
  [[nodiscard]] Triangle end() const noexcept { return StripMesh::triangle(cut); }
};

/// The meshes are a StripMesh and, from scratch, a ColoringCopy.
class ChainSearch {
 public:
  using Halfedge = StripMesh::Halfedge;

  /// Sums over all calls.
  struct Counts {
    std::uint64_t looked = 0;  ///< ends examined
    std::uint64_t walked = 0;  ///< triangles passed by walks that look for cycles
    std::uint64_t made = 0;    ///< moves made and not undone
  };
  /// The number of triangles that a walk passes on either side before the move is refused.
  static constexpr std::uint32_t max_walk = 3000;

  explicit ChainSearch(Cost cost = Cost::indices()) noexcept : cost_(cost) {}

  /// Begins at the ends among the given triangles, at ends across a dashed edge of the others, and last, if looks are
  /// left, with cuts at their swaps that raise the cost by `worse` at most. The triangles must be alive; some may be
  /// named twice. The mesh must have a valid colouring. Returns the changes in counts; the cost never rises. Throws
  /// std::bad_alloc before anything changes or while the mesh is watched; the colouring is then valid, but changes are
  /// not reported.
  template <class Mesh>
  ColoringChange run(Mesh& mesh, std::span<const Triangle> from, const ChainLimits& limits);
  /// Whether a chain may begin in the triangle: a strip ends there, or has a swap, which can be cut if a chain has more
  /// than one move.
  template <class Mesh>
  [[nodiscard]] static bool may_begin(const Mesh& mesh, Triangle t, const ChainLimits& limits);
  /// Calls run() for each triangle of the mesh in which a chain may begin, once, in order.
  template <class Mesh>
  ColoringChange run_everywhere(Mesh& mesh, const ChainLimits& limits, detail::Poll& poll);

  /// The moves that begin at an end and whose price is at most `highest`, in a fixed order, without a test for cycles.
  /// Valid until the next call of any function.
  template <class Mesh>
  [[nodiscard]] std::span<const ChainMove> moves_at(const Mesh& mesh, Triangle end, std::int32_t highest);
  /// The strip cut at h, which is solid, if that is a swap; the cut's end is on the side of h.
  template <class Mesh>
  [[nodiscard]] std::optional<ChainMove> cut_at(const Mesh& mesh, Halfedge h) const noexcept;
  /// True when the move closes no solid cycle; also false when neither walk ends.
  template <class Mesh>
  [[nodiscard]] bool keeps_strips(const Mesh& mesh, const ChainMove& move);

  [[nodiscard]] const Cost& cost() const noexcept { return cost_; }
  [[nodiscard]] const Counts& counts() const noexcept { return counts_; }

 private:
  /// A chain: the parent's, then one move. A chain that begins at an end has a first state without a move; one that
  /// begins with a cut has no parent.
  struct State {
    std::uint32_t parent = none;
    std::uint32_t length = 0;
    Triangle end = none;
    std::int32_t price = 0;
    ChainMove move{};
  };

  void offer(const ChainMove& move, std::int32_t highest) noexcept;
  template <class Mesh>
  void consider(const Mesh& mesh, Triangle t, std::vector<Triangle>& ends);
  template <class Mesh>
  bool add_cuts(Mesh& mesh, std::span<const Triangle> from, std::int32_t highest);
  template <class Mesh>
  bool search(Mesh& mesh, std::span<const Triangle> from, const ChainLimits& limits);
  template <class Mesh>
  bool try_chain(Mesh& mesh, std::uint32_t s);
  template <class Mesh>
  void make_chain(Mesh& mesh, std::uint32_t s, const ChainMove& last);
  void next_mark() noexcept;

  Cost cost_;
  Counts counts_;
  ColoringChange done_;
  std::uint64_t last_look_ = 0;
  std::array<ChainMove, 6> moves_{};  // found last, by price
  std::size_t move_count_ = 0;
  std::vector<Triangle> ends_;  // where chains begin
  std::vector<Triangle> touched_;
  std::vector<State> states_;   // breadth first
  std::uint32_t tried_ = none;  // the state whose chain is on the mesh
  std::vector<std::uint32_t> path_;
  std::vector<ChainMove> chain_;
  std::vector<std::uint32_t> marks_;  // by triangle: mark_ if it is in ends_ or the end of a state
  std::uint32_t mark_ = 0;
};

}  // namespace restrip
