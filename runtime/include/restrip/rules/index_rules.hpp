// Rules of the index cost: for a fan of any valence, the recolouring that keeps every port and takes the fewest
// indices, looked up in the index automaton (restrip/tables/index_automaton.hpp). Not part of restrip/restrip.hpp:
// include this header by itself.
//
// The cost of a colouring is restart * strips + swap * swaps + isolated * isolated triangles (restrip/mesh/cost.hpp),
// with the weights of the automaton: 3, 1 and 0, so that it is the length of an index buffer up to a constant. For
// other weights put the folder of an automaton of your own (`restrip-generate automaton --cost R,S,I`) before the
// library's on the include path.
//
// A rule recolours the inner edges of a patch and leaves every port as it is. Whether a port is a swap depends on how
// its strip turns in the fan, which the rule decides, and on how it turns in the triangle behind the port, which the
// caller tells; so swaps at ports are counted exactly. Of all such recolourings that are sound whatever lies outside
// (docs/notation.md), these functions return one of the least cost. Between several it is the same on every machine.
//
// Input, for a fan in the numbering of docs/notation.md. Halfedges as in restrip/mesh/mesh.hpp; h is the halfedge of
// triangle t_i whose dual edge is port p_i.
//  - `ports`, `joined`: as for restrip/rules/exact.hpp. A caller that does not know whether two ports are joined leaves
//    the bit 0: the rule then does not join them, which is sound either way.
//  - `left`: bit i is set when the strip behind the solid port goes on over the dual edge of next(opposite(h)), so
//    about the corner that the port shares with the link to t_{i-1}.
//  - `right`: the same with next(next(opposite(h))) and t_{i+1}.
//    Where neither is set, the strip ends behind the port. Bits of ports that are not solid are ignored; a caller that
//    does not know sets neither, and then swaps at this port are not counted.
// Any masks are safe. Positions are any, as for restrip/rules/exact.hpp. k is less than 2^26.
//
// Complexity of a look-up. Four table reads for each triangle forwards and three backwards, and for a split some dozens
// of pairs of cases, at most 200, whatever k is. On words, and on bit strings with k <= 64: no allocation, nothing
// thrown. Longer bit strings: one allocation of two bytes for each triangle. The tables are 22 KB, and the compiler
// makes another 5 KB of them.
//
// Swaps: Evans, Skiena, Varshney, "Optimizing triangle strips for fast rendering", 1996.
#pragma once

#include <cstddef>
#include <vector>

#include "restrip/precondition.hpp"
#include "restrip/rules/bits.hpp"
#include "restrip/rules/impl/index_walk.hpp"
#include "restrip/rules/impl/layout.hpp"
#include "restrip/rules/key.hpp"

namespace restrip::index_rules {

/// What a rule must know of a fan with k <= max_word_valence.
struct Key {
  Word ports = 0;
  Word joined = 0;
  Word left = 0;
  Word right = 0;

  friend constexpr bool operator==(const Key&, const Key&) noexcept = default;
};

/// The key of a fan of any size; k bits each.
struct LongKey {
  BitSpan ports;
  BitSpan joined;
  BitSpan left;
  BitSpan right;
};

/// A recolouring that fits one word. `cost` is that of the whole patch after the operation: restart for each triangle
/// less restart for each solid inner edge, a swap for each inner edge and each port that is one, and what isolated
/// triangles cost. Two recolourings of the same patch differ by as much as the cost of the mesh does.
struct Recoloring {
  Word colors = 0;
  int cost = 0;

  friend constexpr bool operator==(const Recoloring&, const Recoloring&) noexcept = default;
};

namespace detail {

using restrip::detail::IndexArc;
using restrip::detail::Layout;
using restrip::detail::LongLetters;
using restrip::detail::TurnLetters;
using restrip::detail::WordLetters;

/// Up to here a bit string is answered on the stack.
inline constexpr std::size_t max_stack_valence = 64;

constexpr auto letters_of(const Key& key, bool closed) noexcept {
  return TurnLetters{
      closed ? WordLetters::of_closed(key.ports, key.joined) : WordLetters::of_open(key.ports, key.joined), key.left,
      key.right};
}

constexpr auto letters_of(std::size_t k, const LongKey& key, bool closed) noexcept {
  return TurnLetters{
      closed ? LongLetters::of_closed(k, key.ports, key.joined) : LongLetters::of_open(k, key.ports, key.joined),
      key.left, key.right};
}

constexpr int cost_of_triangles(const Layout& patch) noexcept {
  return static_cast<int>(patch.size()) * tables::index_automaton.restart;
}

/// walk(room, color) as in index_walk.hpp.
template <class Walk>
constexpr Recoloring on_word(const Layout& patch, Walk&& walk) noexcept {
  IndexArc::Entry room[max_stack_valence];
  Recoloring result;
  result.cost = cost_of_triangles(patch) +
                walk(room, [&](std::size_t edge, bool solid) { result.colors |= Word{solid} << edge; });
  return result;
}

template <class Walk>
int on_bits(const Layout& patch, MutableBitSpan colors, Walk&& walk) {
  const auto write = [&](IndexArc::Entry* room) {
    if (patch.colors() > 0) colors.clear(patch.colors());
    return cost_of_triangles(patch) + walk(room, [&](std::size_t edge, bool solid) {
             if (solid) colors.set(edge);
           });
  };
  if (patch.k <= max_stack_valence) {
    IndexArc::Entry room[max_stack_valence];
    return write(room);
  }
  std::vector<IndexArc::Entry> room(patch.k);
  return write(room.data());
}

}  // namespace detail

// ---- Words: k <= max_word_valence, constexpr, noexcept ----

/// Closed fan to ring with chord, k >= 3, 1 <= a < k: `colors` is `inner`, k + 3 bits.
constexpr Recoloring best_split(std::size_t k, std::size_t a, const Key& key) noexcept {
  RESTRIP_ASSERT(1 <= a && a < k && k >= 3 && k <= max_word_valence, "index_rules::best_split",
                 restrip::detail::no_such_split);
  return detail::on_word(restrip::detail::ring_with_chord(k, a), [&](auto* room, auto&& color) {
    return restrip::detail::walk_index_split(k, a, detail::letters_of(key, true), room, color);
  });
}

/// Ring with chord to closed fan, k >= 3, whatever the position: `colors` is `loop`, k bits.
constexpr Recoloring best_collapse(std::size_t k, const Key& key) noexcept {
  RESTRIP_ASSERT(k >= 3 && k <= max_word_valence, "index_rules::best_collapse", restrip::detail::no_such_closed_fan);
  return detail::on_word(restrip::detail::closed_fan(k), [&](auto* room, auto&& color) {
    return restrip::detail::walk_index_collapse(k, detail::letters_of(key, true), room, color);
  });
}

/// Open fan to path with chord, 0 <= i < j <= k: `colors` is `inner`, k + 2 bits.
constexpr Recoloring best_open_split(std::size_t k, std::size_t i, std::size_t j, const Key& key) noexcept {
  RESTRIP_ASSERT(i < j && j <= k && k <= max_word_valence, "index_rules::best_open_split",
                 restrip::detail::no_such_gaps);
  return detail::on_word(restrip::detail::path_with_chord(k, i, j), [&](auto* room, auto&& color) {
    return restrip::detail::walk_index_open_split(k, i, j, detail::letters_of(key, false), room, color);
  });
}

/// Open fan to path, k >= 1, 0 <= i <= k: `colors` is `inner`, k bits.
constexpr Recoloring best_boundary_split(std::size_t k, std::size_t i, const Key& key) noexcept {
  RESTRIP_ASSERT(k >= 1 && i <= k && k <= max_word_valence, "index_rules::best_boundary_split",
                 restrip::detail::no_such_gap);
  return detail::on_word(restrip::detail::path(k, i), [&](auto* room, auto&& color) {
    return restrip::detail::walk_index_boundary_split(k, i, detail::letters_of(key, false), room, color);
  });
}

/// Path, with chord or without, to open fan, k >= 1, whatever the position: `colors` is `loop`, k - 1 bits.
constexpr Recoloring best_fan_collapse(std::size_t k, const Key& key) noexcept {
  RESTRIP_ASSERT(k >= 1 && k <= max_word_valence, "index_rules::best_fan_collapse", restrip::detail::no_such_fan);
  return detail::on_word(restrip::detail::open_fan(k), [&](auto* room, auto&& color) {
    return restrip::detail::walk_index_fan_collapse(k, detail::letters_of(key, false), room, color);
  });
}

// ---- Bit strings: any k ----
//
// The colours go to the last argument; the words that hold them are overwritten and must not be those of the key.
// Returned is what `Recoloring::cost` would be.

/// `inner` has k + 3 bits.
inline int best_split(std::size_t k, std::size_t a, const LongKey& key, MutableBitSpan inner) {
  RESTRIP_ASSERT(1 <= a && a < k && k >= 3, "index_rules::best_split", restrip::detail::no_such_split);
  return detail::on_bits(restrip::detail::ring_with_chord(k, a), inner, [&](auto* room, auto&& color) {
    return restrip::detail::walk_index_split(k, a, detail::letters_of(k, key, true), room, color);
  });
}

/// `loop` has k bits.
inline int best_collapse(std::size_t k, const LongKey& key, MutableBitSpan loop) {
  RESTRIP_ASSERT(k >= 3, "index_rules::best_collapse", restrip::detail::no_such_closed_fan);
  return detail::on_bits(restrip::detail::closed_fan(k), loop, [&](auto* room, auto&& color) {
    return restrip::detail::walk_index_collapse(k, detail::letters_of(k, key, true), room, color);
  });
}

/// `inner` has k + 2 bits.
inline int best_open_split(std::size_t k, std::size_t i, std::size_t j, const LongKey& key, MutableBitSpan inner) {
  RESTRIP_ASSERT(i < j && j <= k, "index_rules::best_open_split", restrip::detail::no_such_gaps);
  return detail::on_bits(restrip::detail::path_with_chord(k, i, j), inner, [&](auto* room, auto&& color) {
    return restrip::detail::walk_index_open_split(k, i, j, detail::letters_of(k, key, false), room, color);
  });
}

/// `inner` has k bits.
inline int best_boundary_split(std::size_t k, std::size_t i, const LongKey& key, MutableBitSpan inner) {
  RESTRIP_ASSERT(k >= 1 && i <= k, "index_rules::best_boundary_split", restrip::detail::no_such_gap);
  return detail::on_bits(restrip::detail::path(k, i), inner, [&](auto* room, auto&& color) {
    return restrip::detail::walk_index_boundary_split(k, i, detail::letters_of(k, key, false), room, color);
  });
}

/// `loop` has k - 1 bits; nothing is written when k = 1.
inline int best_fan_collapse(std::size_t k, const LongKey& key, MutableBitSpan loop) {
  RESTRIP_ASSERT(k >= 1, "index_rules::best_fan_collapse", restrip::detail::no_such_fan);
  return detail::on_bits(restrip::detail::open_fan(k), loop, [&](auto* room, auto&& color) {
    return restrip::detail::walk_index_fan_collapse(k, detail::letters_of(k, key, false), room, color);
  });
}

}  // namespace restrip::index_rules
