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
#include "restrip/rules/key.hpp"

namespace restrip::detail {

/// Isolated triangles of a patch with these colours.
constexpr int isolated(const Patch& patch, Word inner, Word ports) noexcept {
  const Word edges = inner & low_bits(patch.edges());
  const Word wrap = edges >> (patch.size() - 1);  // of a ring; a path lacks this edge
  Word touched = edges | edges << 1 | wrap | patch.spread(ports);
  if (patch.has_chord() && has(inner, patch.chord())) touched |= bit(patch.inserted) | bit(patch.opposite);
  return static_cast<int>(patch.size()) - count_bits(touched & low_bits(patch.size()));
}

constexpr int isolated(const Patch& patch, BitSpan inner, BitSpan ports) noexcept {
  int n = 0;
  for (std::size_t m = 0; m < patch.size(); ++m) {
    const bool above = (patch.ring || m + 1 < patch.size()) && inner[m];
    const bool below = m > 0 ? inner[m - 1] : patch.ring && inner[patch.size() - 1];
    const bool third = patch.is_fan(m) ? ports[patch.port(m)] : patch.has_chord() && inner[patch.chord()];
    n += above || below || third ? 0 : 1;
  }
  return n;
}

}  // namespace restrip::detail

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

/// For the patch after the operation, on words: k <= max_word_valence. `colors` has patch.colors() bits.
constexpr Recoloring best(const Patch& patch, Word ports, Word joined) noexcept {
  RESTRIP_ASSERT(patch.k <= max_word_valence, "exact::best", detail::no_such_fan);
  detail::ArcEntry room[max_word_valence + 2];
  Recoloring result;
  detail::walk_arcs(patch, detail::WordLetters(patch, ports, joined), room,
                    [&](std::size_t edge, bool solid) { result.colors |= Word{solid} << edge; });
  result.value = {count_bits(result.colors), detail::isolated(patch, result.colors, ports)};
  return result;
}

/// On bit strings: any k. The colours go to the last argument; the words that hold them are overwritten and must not be
/// the words of the key.
inline Value best(const Patch& patch, BitSpan ports, BitSpan joined, MutableBitSpan colors) {
  const auto write = [&](detail::ArcEntry* room) {
    Value value;
    colors.clear(patch.colors());
    detail::walk_arcs(patch, detail::LongLetters(patch, ports, joined), room, [&](std::size_t edge, bool solid) {
      if (!solid) return;
      colors.set(edge);
      ++value.solid;
    });
    value.isolated = detail::isolated(patch, colors, ports);
    return value;
  };
  constexpr std::size_t max_stack_valence = 64;
  if (patch.k <= max_stack_valence) {
    detail::ArcEntry room[max_stack_valence + 2];
    return write(room);
  }
  std::vector<detail::ArcEntry> room(patch.k + 2);
  return write(room.data());
}

}  // namespace restrip::exact
