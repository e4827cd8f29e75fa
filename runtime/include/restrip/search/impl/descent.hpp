// Descent: lowers the cost of a colouring by small changes, best first.
//
// A *move* changes one dual edge and the edges that must change with it:
//  - a solid edge is cut, or
//  - a dashed edge becomes solid. A triangle that already has two solid edges loses one of them, so a move exchanges an
//    edge for none, one or two others.
// The price of a move is the change of the cost. It follows from the two triangles of the edge and at most four
// triangles beyond each. A walk along the strip from both sides at once tests moves about to be made for solid cycles.
//
// Steepest descent: the given triangles are examined in turn. Of all moves at the edges of a triangle the best one that
// lowers the cost is made, and the triangles it touches are examined again. With *chains*, if no single move lowers the
// cost, a move that costs a little is tried together with the best move after it.
//
//   Descent descent(Cost::indices());
//   descent.run(mesh, changed_triangles, {.moves = 200});
//
// Everything is deterministic. After warm-up nothing is allocated. Single moves of this kind are the neighbourhood of
// the searches for Hamiltonian paths by rotation (Pósa, "Hamiltonian circuits in random graphs", 1976); chains of them
// are due to Lin and Kernighan (1973).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "restrip/mesh/cost.hpp"
#include "restrip/search/sided_mesh.hpp"

namespace restrip {

/// One move, as described above.
struct StripMove {
  StripMesh::Halfedge edge{};                     ///< cleared if it is solid, set if it is dashed
  std::array<StripMesh::Halfedge, 2> given_up{};  ///< solid edges cleared at its two triangles, or {none}
  ColoringChange change{};
  std::int32_t price = 0;  ///< of that change
};

namespace detail {
/// The moves at one triangle; at most six.
struct FoundMoves {
  std::array<StripMove, 6> moves{};
  std::size_t count = 0;

  void offer(const StripMove& move, std::int32_t highest) noexcept {
    if (move.price <= highest) moves[count++] = move;
  }
  /// By price, stably.
  void sort() noexcept {
    for (std::size_t i = 1; i < count; ++i)
      for (std::size_t j = i; j > 0 && moves[j].price < moves[j - 1].price; --j) std::swap(moves[j], moves[j - 1]);
  }
  [[nodiscard]] const StripMove* begin() const noexcept { return moves.data(); }
  [[nodiscard]] const StripMove* end() const noexcept { return moves.data() + count; }
};
}  // namespace detail

/// The limits of one call of Descent::run.
struct DescentLimits {
  std::uint32_t moves = (std::numeric_limits<std::uint32_t>::max)();  ///< moves priced; the last triangle may exceed it
  std::uint32_t tries = 0;  ///< chains: first moves tried at each triangle without a gainful move; 0: no chains
  std::int32_t worse = 0;   ///< chains: the highest price of their first move
};

/// Sums over all calls.
struct DescentCounts {
  std::uint64_t priced = 0;  ///< moves whose price was computed
  std::uint64_t walked = 0;  ///< triangles walked past to find cycles
  std::uint64_t made = 0;    ///< moves made, including moves undone
};

class Descent {
 public:
  using Halfedge = StripMesh::Halfedge;

  explicit Descent(Cost cost = Cost::indices()) noexcept : cost_(cost) {}

  /// Descends from the given triangles, which must be alive; some may be named twice. The mesh must have a valid
  /// colouring, and has one after each single change of a colour. Returns the changes in counts; the cost never rises.
  /// If a call for all triangles changes nothing, the colouring is a local minimum: no move lowers the cost, except
  /// moves refused because a walk is too long (max_walk).
  ///
  /// Throws std::bad_alloc; the colouring is valid then, but the changes are not reported.
  ColoringChange run(SidedMesh auto& mesh, std::span<const Triangle> from, const DescentLimits& limits = {});

  /// The moves at the edges of t whose price is at most `highest`, in a fixed order, without a test for cycles. At most
  /// six. Constant time.
  [[nodiscard]] std::span<const StripMove> moves_at(const SidedMesh auto& mesh, Triangle t, std::int32_t highest);
  /// True when the move closes no solid cycle. Walks along the strip; also false when neither walk ends.
  [[nodiscard]] bool keeps_strips(const SidedMesh auto& mesh, const StripMove& move);
  /// Makes the move, which must keep strips.
  void make(SidedMesh auto& mesh, const StripMove& move);

  [[nodiscard]] const Cost& cost() const noexcept { return cost_; }
  [[nodiscard]] const DescentCounts& counts() const noexcept { return counts_; }

  /// The number of triangles that a walk passes on either side before the move is refused.
  static constexpr std::uint32_t max_walk = 3000;

 private:
  void find_moves(const SidedMesh auto& mesh, Triangle t, std::int32_t highest, std::span<const Triangle> looked);
  void touch(const SidedMesh auto& mesh, const StripMove& move);

  Cost cost_;
  DescentCounts counts_;
  ColoringChange done_;
  detail::FoundMoves found_;
  // Triangles examined since the last change of a colour: their edges need not be examined again, from either side.
  std::array<Triangle, 24> looked_{};
  std::size_t looked_count_ = 0;
  std::vector<Triangle> queue_;
  std::vector<Triangle> touched_;
};

}  // namespace restrip

#include "restrip/search/impl/descent_moves.hpp"
