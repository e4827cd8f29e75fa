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

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

#include "restrip/mesh/cost.hpp"
#include "restrip/search/impl/descent.hpp"
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

namespace detail {

/// Whether a triangle with these solid sides is an end of a strip: it has at most one.
constexpr bool is_strip_end(unsigned solid) noexcept { return (0b00010111U >> solid & 1U) != 0; }

/// Trial moves, undone before the search returns. A watched StripMesh does not report them.
class TrialColors {
 public:
  static void make(SidedMesh auto& mesh, const StripMove& move) noexcept {
    if (move.given_up[1].id != none) color(mesh, move.given_up[1], false);
    color(mesh, move.edge, true);
  }
  static void take_back(SidedMesh auto& mesh, const StripMove& move) noexcept {
    color(mesh, move.edge, false);
    if (move.given_up[1].id != none) color(mesh, move.given_up[1], true);
  }

 private:
  template <SidedMesh Mesh>
  static void color(Mesh& mesh, StripMesh::Halfedge h, bool solid) noexcept {
    if constexpr (std::same_as<Mesh, StripMesh>)
      mesh.color(h, solid);
    else
      mesh.set_solid(h, solid);
  }
};

}  // namespace detail

void EndSearch::find_moves(const SidedMesh auto& mesh, Triangle end, std::int32_t highest, Found& found) {
  ++counts_.looked;
  found.count = 0;
  const unsigned solid = mesh.solid_sides(end);
  const int isolated = solid == 0 ? -1 : 0;  // change at the end
  Triangle last = none;                      // the triangle before the end in its strip
  unsigned turn_last = 0;                    // of the strip at that triangle, seen from the end
  if (solid != 0) {
    const Halfedge kept = mesh.opposite(detail::lowest_side(end, solid));
    last = StripMesh::triangle(kept);
    turn_last = mesh.other_solid_sides(kept);
  }
  for (unsigned dashed = 7U & ~solid; dashed != 0; dashed &= dashed - 1) {
    const Halfedge edge = detail::lowest_side(end, dashed);
    const Halfedge back = mesh.opposite(edge);
    if (StripMesh::on_boundary(back) || StripMesh::triangle(back) == end) continue;
    ++counts_.priced;
    const unsigned turn_end = mesh.other_solid_sides(edge);  // of the strip, seen from the edge; 0 if end is isolated
    const int swaps = int{turn_end != 0} & int{turn_last == turn_end};
    if (detail::is_strip_end(mesh.solid_sides(StripMesh::triangle(back)))) {
      // Another strip ends across the edge.
      const unsigned turn = mesh.other_solid_sides(back);
      StripMove move{edge, {}, {-1, swaps + detail::is_swap(turn_end, turn), isolated}};
      if (turn != 0) {
        const Halfedge kept = detail::neighbor_at(mesh, back, turn);
        // Two triangles that share two edges and follow each other already.
        if (StripMesh::triangle(kept) == end) continue;
        move.change.swaps += int{mesh.other_solid_sides(kept) == turn};
      } else {
        --move.change.isolated;
      }
      move.price = move.change.price(cost_);
      found.offer(move, highest);
      continue;
    }
    // A strip passes across the edge.
    const std::array<Halfedge, 2> towards{detail::neighbor_at(mesh, back, 1), detail::neighbor_at(mesh, back, 2)};
    if (StripMesh::triangle(towards[0]) == end || StripMesh::triangle(towards[1]) == end) continue;
    const std::array<unsigned, 2> turn{mesh.other_solid_sides(towards[0]), mesh.other_solid_sides(towards[1])};
    for (unsigned keeps = 1; keeps <= 2; ++keeps) {
      const unsigned gives = 3 - keeps;
      const unsigned turn_freed = turn[gives - 1];
      StripMove move{edge, {Halfedge{}, towards[gives - 1]}, {}};
      move.change.isolated = isolated + int{turn_freed == 0};
      move.change.swaps = swaps + detail::is_swap(turn_end, keeps) + int{turn[keeps - 1] == keeps} -
                          int{turn[keeps - 1] == gives} - int{turn_freed == keeps};
      // One more swap may disappear, on the other side of the triangle that becomes an end.
      if (move.change.price(cost_) - std::int32_t{cost_.swap} > highest) continue;
      if (StripMesh::triangle(move.given_up[1]) == last) {
        // The three triangles lie around one vertex.
        detail::MoveOverlay colors(mesh);
        colors.change(move.given_up[1], false);
        colors.change(move.edge, true);
        move.change = colors.difference();
      } else if (turn_freed != 0) {
        move.change.swaps -= detail::swap_beyond(mesh, move.given_up[1], turn_freed);
      }
      move.price = move.change.price(cost_);
      found.offer(move, highest);
    }
  }
}

std::span<const StripMove> EndSearch::moves_at(const SidedMesh auto& mesh, Triangle end, std::int32_t highest) {
  RESTRIP_ASSERT(mesh.alive(end) && detail::is_strip_end(mesh.solid_sides(end)), "EndSearch::moves_at",
                 "no strip ends in the triangle");
  find_moves(mesh, end, highest, found_);
  return {found_.begin(), found_.end()};
}

// ---- the queue of ends to examine

// Moves an examined end to the end of the queue.
inline void EndSearch::look_later(Triangle end) noexcept {
  for (std::size_t i = 0; i < end_count_; ++i) {
    if (ends_[i].triangle != end || ends_[i].tried == done_with) continue;
    if (ends_[i].tried == 0) return;
    ends_[i].tried = done_with;
    break;
  }
  if (end_count_ < max_ends) ends_[end_count_++] = {end, 0};
}

// The triangle, or the end across its only dashed edge.
void EndSearch::consider(const SidedMesh auto& mesh, Triangle t) noexcept {
  const unsigned solid = mesh.solid_sides(t);
  const Halfedge back = mesh.opposite(detail::lowest_side(t, 7U & ~solid));
  // On the boundary this is t itself.
  const Triangle end = detail::is_strip_end(solid) ? t : StripMesh::triangle(back);
  if (detail::is_strip_end(mesh.solid_sides(end))) look_later(end);
}

// ---- moves

void EndSearch::make(SidedMesh auto& mesh, const StripMove& move) {
  const bool joins = move.given_up[1].id == none;
  if (!joins) mesh.set_solid(move.given_up[1], false);
  mesh.set_solid(move.edge, true);
  done_ += move.change;
  ++counts_.made;
  // After an exchange the triangle across the edge is next to the new end.
  if (!joins) look_later(StripMesh::triangle(move.given_up[1]));
  consider(mesh, StripMesh::triangle(move.edge));
  if (joins) consider(mesh, StripMesh::triangle(mesh.opposite(move.edge)));
}

// Continues a chain of `made` trial moves with a total price of `price`. They are unchanged unless this finds a chain
// that lowers the cost.
bool EndSearch::chain(SidedMesh auto& mesh, Triangle end, std::size_t made, std::int32_t price, std::size_t length,
                      const EndLimits& limits) {
  const bool last = made + 1 == length;
  Found found;
  find_moves(mesh, end, (last ? -1 : limits.worse) - price, found);
  found.sort();
  for (const StripMove& move : found) {
    chain_[made] = move;
    if (price + move.price < 0) {
      // A chain that closes a cycle on the way is not made.
      for (std::size_t k = made; k-- > 0;) detail::TrialColors::take_back(mesh, chain_[k]);
      std::size_t sound = 0;
      for (; sound <= made && walks_.keeps_strips(mesh, chain_[sound]); ++sound)
        detail::TrialColors::make(mesh, chain_[sound]);
      if (sound > made) {
        for (std::size_t k = sound; k-- > 0;) detail::TrialColors::take_back(mesh, chain_[k]);
        for (std::size_t k = 0; k <= made; ++k) make(mesh, chain_[k]);
        return true;
      }
      for (; sound < made; ++sound) detail::TrialColors::make(mesh, chain_[sound]);
      continue;
    }
    if (last || move.given_up[1].id == none || counts_.looked >= last_look_) continue;
    detail::TrialColors::make(mesh, move);
    if (chain(mesh, StripMesh::triangle(move.given_up[1]), made + 1, price + move.price, length, limits)) return true;
    detail::TrialColors::take_back(mesh, move);
  }
  return false;
}

ColoringChange EndSearch::run(SidedMesh auto& mesh, std::span<const Triangle> from, const EndLimits& limits) {
  done_ = {};
  end_count_ = 0;
  for (const Triangle t : from) {
    RESTRIP_ASSERT(mesh.alive(t), "EndSearch::run", "a triangle is not one of this mesh");
    consider(mesh, t);
  }
  last_look_ = counts_.looked + limits.looks;
  const auto longest = std::min<std::uint32_t>(limits.length, max_length);
  for (std::uint32_t length = 1; length <= longest && counts_.looked < last_look_;) {
    // Chains of one length at all ends at which they have not been tried; when one is made, shorter ones may be
    // possible.
    bool made = false;
    for (std::size_t i = 0; i < end_count_ && counts_.looked < last_look_ && !made; ++i) {
      if (ends_[i].tried >= length) continue;
      const Triangle end = ends_[i].triangle;
      const bool is_end = detail::is_strip_end(mesh.solid_sides(end));
      ends_[i].tried = is_end ? length : done_with;
      if (!is_end) continue;
      if (length > 1) {
        made = chain(mesh, end, 0, 0, length, limits);
        continue;
      }
      // The best move that lowers the cost, if any.
      find_moves(mesh, end, -1, found_);
      found_.sort();
      const StripMove* const best = std::find_if(
          found_.begin(), found_.end(), [&](const StripMove& move) { return walks_.keeps_strips(mesh, move); });
      if (best != found_.end()) make(mesh, *best);
    }
    length = made ? 1 : length + 1;
  }
  return done_;
}

}  // namespace restrip
