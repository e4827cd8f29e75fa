// How the generated automaton (restrip/tables/automaton.hpp) is laid out: the rules of every fan, whatever its valence,
// in one finite automaton. docs/automaton.md says why it exists and how it is checked; docs/notation.md numbers the
// bits. What follows is all that a look-up needs.
//
// **Arcs.** A cut through two dual edges of a fan leaves an *arc*, a row of triangles between a left and a right
// *link*. It is read from left to right, one *letter* for each triangle:
//
//     0  its port is dashed, or it has none
//     1  its port is solid, and its bit in the key's `joined` is 0
//     2  its port is solid, and its bit in `joined` is 1
//     3  no triangle: the mesh boundary (at most once in an arc)
//
// so a triangle's letter is `port + (port & joined)`. Reading starts in class 0, the empty arc:
//
//     class = next[4 * class + letter]
//
// **Cases.** What a colouring of the arc does at its two links is a *case*, four bits: the reach of the left link times
// four plus the reach of the right link. A reach says where the strand over the link goes on the arc's side:
//
//     0  nowhere, the link is dashed
//     1  it ends inside the arc
//     2  it leaves by a port
//     3  it goes through to the other link; then both reaches are 3, and the case is 15
//
// Once the case of the whole arc is known, the colours are read backwards. `before[4 * class + letter]` has four bits
// for each case after the letter: the case before it, where `class` is the class *before* the letter.
//
//     case = before[4 * class + letter] >> 4 * case & 15
//
// The right link of the arc read so far is solid when `case & 3` is not 0. So each step backwards tells the colour of
// the dual edge to the left of one triangle; the last step, to the empty arc, tells the left link of the whole arc.
//
// **Where the case comes from.** Each family of operations is one or two arcs.
//
// - *Split*, position (k, a). The first arc is t_0 … t_{a-1}, the second t_a … t_{k-1}, in letters from the key of the
//   whole closed fan. With exactly two solid ports the key has both bits of `joined` or none, as
//   docs/notation.md says; here one bit does not stand for both. With x and y
//   the classes of the two arcs
//
//       meeting = meetings[meet[seconds * first[x] + second[y]]]
//
//   has the case of the first arc in bits 0 … 3, that of the second in bits 4 … 7, and the colour of the chord in bit
//   8. Inner edges f_0 … f_a are the links of the first arc and what lies between, f_{a+1} … f_{k+1} those of the
//   second.
// - *Collapse* onto a closed fan. One arc, t_0 … t_{k-1}, class z; `closed[z]` is its case. Both links are e_{k-1}.
// - *Open split*, gaps i < j. The first arc is t_i … t_{j-1}; the second is t_j … t_{k-1}, the letter 3, t_0 …
//   t_{i-1}, either part perhaps empty. Then as for a split. In path order the edges are those behind the letter 3
//   without the first, those of the first arc, and those before the letter 3 without the last: next to the boundary
//   there is no edge, and the cases found have it dashed.
// - *Boundary split*, gap i. One arc, t_0 … t_{i-1}, A with letter 0, t_i … t_{k-1}; its case is 0: both links lie on
//   the boundary.
// - *Collapse* onto an open fan. One arc, t_0 … t_{k-1}; its case is 0.
//
// In an open fan no bit of `joined` is set for the first solid port, so reading it in another order changes nothing.
//
// **Example.** Split at k = 4, a = 2, ports 0000: both arcs are the letters 0, 0. Their class says that everything
// may be solid, the meeting that it is, but for one edge: all but one edge of the ring of six.
//
// **Complexity.** One table access for each triangle forwards, and one backwards; the accesses backwards do not wait
// for each other, because the classes are known by then. Steps of two or more triangles can be composed from these
// tables at compile time.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace restrip {

/// What `next` holds where a letter is not allowed: the boundary behind a boundary.
inline constexpr std::uint8_t no_arc_class = 255;

/// The automaton. `Classes` is at most 255. Entries that nothing asks for hold 0: `first` and `closed` of arcs with the
/// boundary inside or without triangles, `second` of the empty arc, four bits of `before` for a case that no answer
/// has.
template <std::size_t Classes, std::size_t Firsts, std::size_t Seconds, std::size_t Meetings>
struct ArcAutomaton {
  static constexpr std::size_t classes = Classes;
  static constexpr std::size_t seconds = Seconds;

  std::array<std::uint8_t, 4 * Classes> next;       ///< index 4 * class + letter
  std::array<std::uint64_t, 4 * Classes> before;    ///< index 4 * class + letter, four bits for each case after it
  std::array<std::uint8_t, Classes> closed;         ///< the case of an arc that is a whole closed fan
  std::array<std::uint8_t, Classes> first;          ///< row of an arc between A and D
  std::array<std::uint8_t, Classes> second;         ///< column of an arc between D and A
  std::array<std::uint8_t, Firsts * Seconds> meet;  ///< index seconds * row + column, into `meetings`
  std::array<std::uint16_t, Meetings> meetings;     ///< case of the first arc | of the second << 4 | chord << 8
};

}  // namespace restrip
