// Rules for rows of any length, looked up by their key in the automaton of rows, which `restrip-generate automaton
// --operation` writes for families of your own whose ports may be given up. Call the look-up of the family, in the
// header that is written beside it; this is what it asks. docs/automaton.md, "Families of your own", says what is
// served and how the automaton is checked.
//
// A row is what the hole of a vertex becomes when the vertex goes: triangles one after the other around a corner, each
// with one port, the first and the last perhaps with a second one. A recolouring is sound when every triangle keeps at
// most two solid edges and it joins only ports that were joined before. Among the sound ones these functions return one
// with the fewest strips; of those one with the fewest isolated triangles and ports given up together; of those one
// with the fewest ports given up. That is the default cost of operation files.
//
// Input. `ports` has a bit for each port, `joined` too: bit i is set when port i is solid and joined, before the
// operation, to the solid port that precedes it cyclically; with exactly two solid ports either bit stands for the
// pair. Bits of `joined` without a solid port are ignored. Any pair of masks is safe: the answer joins no other pairs.
// A row out of range is a programming error, found in debug builds (precondition.hpp). There are fewer than 2^31
// triangles.
//
// Complexity. Two table reads for each triangle: time linear in the length. On words, and on bit strings with up to 64
// ports: no allocation, nothing thrown. Longer bit strings: one allocation of two bytes for each port.
#pragma once

#include <cstddef>
#include <vector>

#include "restrip/precondition.hpp"
#include "restrip/rules/bits.hpp"
#include "restrip/rules/impl/row_walk.hpp"

namespace restrip::exact {

/// The triangles of a row and where its ports lie among those of the patch, in cyclic order: `first` and those behind
/// it.
using Row = restrip::detail::Row;

/// What is best: solid inner edges and isolated triangles after the operation, and how many of `ports` are given up.
using RowValue = restrip::detail::RowValue;

/// A recolouring that fits one word, and its value.
struct RowRecoloring {
  Word colors = 0;  ///< bit i is the edge between triangles i and i + 1 of the row
  Word kept = 0;    ///< the ports that stay solid
  RowValue value;
};

/// One triangle at least, at most 64 ports.
template <const auto& automaton>
constexpr RowRecoloring best_row(const Row& row, Word ports, Word joined) noexcept {
  RESTRIP_ASSERT(row.triangles >= 1 && row.ports() <= word_bits && row.first < row.ports(), "exact::best_row",
                 restrip::detail::no_such_row);
  restrip::detail::ArcEntry room[word_bits]{};
  RowRecoloring result;
  result.value =
      restrip::detail::walk_row<automaton>(row, BitSpan::of(ports), BitSpan::of(joined), room,
                                           MutableBitSpan::of(result.colors), MutableBitSpan::of(result.kept));
  return result;
}

/// The same for bit strings of any length. `colors` has a bit less than there are triangles, `kept` one for each port;
/// the words that hold them are overwritten and must not be those of the key.
template <const auto& automaton>
RowValue best_row(const Row& row, BitSpan ports, BitSpan joined, MutableBitSpan colors, MutableBitSpan kept) {
  RESTRIP_ASSERT(row.triangles >= 1 && row.first < row.ports(), "exact::best_row", restrip::detail::no_such_row);
  restrip::detail::ArcEntry room[word_bits];
  std::vector<restrip::detail::ArcEntry> longer(row.ports() <= word_bits ? 0 : row.ports());
  return restrip::detail::walk_row<automaton>(row, ports, joined, longer.empty() ? room : longer.data(), colors, kept);
}

}  // namespace restrip::exact
