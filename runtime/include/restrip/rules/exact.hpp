// Rules for fans of any valence, looked up by their key in the automaton of all valences
// (restrip/tables/automaton.hpp): all open fans, and closed ones too large for the tables. For small closed fans they
// are as good as the rules of the tables. docs/explanation/automaton.md says how they are checked.
//
// A recolouring keeps every port. It is sound when every triangle keeps at most two solid edges, nothing inside is a
// solid cycle, and it joins only ports that were joined before. Of all sound recolourings these functions return one
// with the most solid edges, and among these one with the fewest isolated triangles. docs/reference/notation.md has the
// order of preference, the numbering of all bits, and the proof that only (ports, joined) matters. Remaining ties are
// broken in the same way on every machine, but not as in the tables: compare counts with the tables, not colours.
//
// Input. `ports` has k bits. `joined` has k bits as restrip/rules/key.hpp computes them; with exactly two solid ports
// in a closed fan either bit stands for the pair. Bits of `joined` without a solid port are ignored. Any pair of masks
// is safe: for a key that no valid configuration has, the result is still the best recolouring that joins no other
// pairs. All positions are supported (1 <= a < k, gaps i < j), not only the ones listed in docs/reference/notation.md.
// A position out of range is a programming error, found in debug builds (precondition.hpp). k is less than 2^26.
//
// Complexity. Two table reads for each triangle: time linear in k. Words, and bit strings with k <= 64, neither
// allocate nor throw. Longer bit strings make one allocation of two bytes a triangle.
#pragma once

#include <cstddef>
#include <vector>

#include "restrip/precondition.hpp"
#include "restrip/rules/bits.hpp"
#include "restrip/rules/impl/arc_walk.hpp"
#include "restrip/rules/impl/layout.hpp"
#include "restrip/rules/key.hpp"

namespace restrip::exact {

/// The value of a recolouring: solid inner edges and isolated triangles in the patch after the operation.
struct Value {
  int solid = 0;
  int isolated = 0;

  friend constexpr bool operator==(const Value&, const Value&) noexcept = default;
};

/// A recolouring that fits one word, and its value.
struct Recoloring {
  Word colors = 0;
  Value value;
};

}  // namespace restrip::exact

namespace restrip::detail {

/// The functions below, for the patch after the operation.
constexpr exact::Recoloring best_recoloring(const Layout& patch, Word ports, Word joined) noexcept {
  ArcEntry room[max_word_valence + 2];
  exact::Recoloring result;
  walk_arcs(patch, WordLetters(patch, ports, joined), room,
            [&](std::size_t edge, bool solid) { result.colors |= Word{solid} << edge; });
  result.value = {count_bits(result.colors), isolated(patch, result.colors, ports)};
  return result;
}

inline exact::Value best_recoloring(const Layout& patch, BitSpan ports, BitSpan joined, MutableBitSpan colors) {
  const auto write = [&](ArcEntry* room) {
    exact::Value value;
    colors.clear(patch.colors());
    walk_arcs(patch, LongLetters(patch, ports, joined), room, [&](std::size_t edge, bool solid) {
      if (!solid) return;
      colors.set(edge);
      ++value.solid;
    });
    value.isolated = isolated(patch, colors, ports);
    return value;
  };
  constexpr std::size_t max_stack_valence = 64;
  if (patch.k <= max_stack_valence) {
    ArcEntry room[max_stack_valence + 2];
    return write(room);
  }
  std::vector<ArcEntry> room(patch.k + 2);
  return write(room.data());
}

}  // namespace restrip::detail

namespace restrip::exact {

// ---- Words: k <= max_word_valence, constexpr, noexcept ----

/// Closed fan to ring with chord, k >= 2, 1 <= a < k: `colors` is `inner`, k + 3 bits.
constexpr Recoloring best_split(std::size_t k, std::size_t a, Word ports, Word joined) noexcept {
  RESTRIP_ASSERT(1 <= a && a < k && k <= max_word_valence, "exact::best_split", detail::no_such_arc);
  return detail::best_recoloring(detail::ring_with_chord(k, a), ports, joined);
}

/// Ring with chord to closed fan, k >= 1, at any position: `colors` is `loop`, k bits.
constexpr Recoloring best_collapse(std::size_t k, Word ports, Word joined) noexcept {
  RESTRIP_ASSERT(k >= 1 && k <= max_word_valence, "exact::best_collapse", detail::no_such_fan);
  return detail::best_recoloring(detail::closed_fan(k), ports, joined);
}

/// Open fan to path with chord, 0 <= i < j <= k: `colors` is `inner`, k + 2 bits.
constexpr Recoloring best_open_split(std::size_t k, std::size_t i, std::size_t j, Word ports, Word joined) noexcept {
  RESTRIP_ASSERT(i < j && j <= k && k <= max_word_valence, "exact::best_open_split", detail::no_such_gaps);
  return detail::best_recoloring(detail::path_with_chord(k, i, j), ports, joined);
}

/// Open fan to path, k >= 1, 0 <= i <= k: `colors` is `inner`, k bits.
constexpr Recoloring best_boundary_split(std::size_t k, std::size_t i, Word ports, Word joined) noexcept {
  RESTRIP_ASSERT(k >= 1 && i <= k && k <= max_word_valence, "exact::best_boundary_split", detail::no_such_gap);
  return detail::best_recoloring(detail::path(k, i), ports, joined);
}

/// Path, with chord or without, to open fan, k >= 1, at any position: `colors` is `loop`, k - 1 bits.
constexpr Recoloring best_fan_collapse(std::size_t k, Word ports, Word joined) noexcept {
  RESTRIP_ASSERT(k >= 1 && k <= max_word_valence, "exact::best_fan_collapse", detail::no_such_fan);
  return detail::best_recoloring(detail::open_fan(k), ports, joined);
}

// ---- Bit strings: any k ----
//
// The colours go to the last argument; the words that hold them are overwritten and must not be the words of the key.

/// `inner` has k + 3 bits.
inline Value best_split(std::size_t k, std::size_t a, BitSpan ports, BitSpan joined, MutableBitSpan inner) {
  RESTRIP_ASSERT(1 <= a && a < k, "exact::best_split", detail::no_such_arc);
  return detail::best_recoloring(detail::ring_with_chord(k, a), ports, joined, inner);
}

/// `loop` has k bits.
inline Value best_collapse(std::size_t k, BitSpan ports, BitSpan joined, MutableBitSpan loop) {
  RESTRIP_ASSERT(k >= 1, "exact::best_collapse", detail::no_such_fan);
  return detail::best_recoloring(detail::closed_fan(k), ports, joined, loop);
}

/// `inner` has k + 2 bits.
inline Value best_open_split(std::size_t k, std::size_t i, std::size_t j, BitSpan ports, BitSpan joined,
                             MutableBitSpan inner) {
  RESTRIP_ASSERT(i < j && j <= k, "exact::best_open_split", detail::no_such_gaps);
  return detail::best_recoloring(detail::path_with_chord(k, i, j), ports, joined, inner);
}

/// `inner` has k bits.
inline Value best_boundary_split(std::size_t k, std::size_t i, BitSpan ports, BitSpan joined, MutableBitSpan inner) {
  RESTRIP_ASSERT(k >= 1 && i <= k, "exact::best_boundary_split", detail::no_such_gap);
  return detail::best_recoloring(detail::path(k, i), ports, joined, inner);
}

/// `loop` has k - 1 bits; nothing is written when k = 1.
inline Value best_fan_collapse(std::size_t k, BitSpan ports, BitSpan joined, MutableBitSpan loop) {
  RESTRIP_ASSERT(k >= 1, "exact::best_fan_collapse", detail::no_such_fan);
  return detail::best_recoloring(detail::open_fan(k), ports, joined, loop);
}

}  // namespace restrip::exact
