// How the generated automaton (restrip/tables/automaton.hpp) is laid out: the rules of every fan, whatever its valence,
// in one finite automaton. docs/explanation/automaton.md says why it exists and how it is checked;
// docs/reference/notation.md numbers the bits. What follows is all that a look-up needs.
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
// four plus the reach of the right link. A reach says where the strand over the link leads on the arc's side:
//
//     0  nowhere, the link is dashed
//     1  it ends inside the arc
//     2  it leaves by a port
//     3  it goes through to the other link; then both reaches are 3, and the case is 15
//
// Once the case of the whole arc is known, the colours are read backwards. `before[4 * class + letter]` has four
// bits for each case after the letter: the case before it, where `class` is the class *before* the letter.
//
//     case = before[4 * class + letter] >> 4 * case & 15
//
// The right link of the arc read so far is solid when `case & 3` is not 0. So each step backwards gives the colour of
// the dual edge to the left of one triangle; the last step, to the empty arc, gives the left link of the whole arc.
//
// **Where the case comes from.** Each family of operations is one or two arcs.
//
// - *Split*, position (k, a). The first arc is t_0 … t_{a-1}, the second t_a … t_{k-1}, in letters from the key of the
//   whole closed fan. With exactly two solid ports the key has both bits of `joined` or none, as
//   docs/reference/notation.md says; here one bit does not stand for both. With x and y
//   the classes of the two arcs
//
//       meeting = meetings[meet[seconds * first[x] + second[y]]]
//
//   has the case of the first arc in bits 0 … 3, the case of the second in bits 4 … 7, and the colour of the chord in
//   bit 8. Inner edges f_0 … f_a are the links of the first arc and the edges between them, f_{a+1} … f_{k+1} the same
//   of the second.
// - *Collapse* onto a closed fan. One arc, t_0 … t_{k-1}, class z; `closed[z]` is its case. Both links are e_{k-1}.
// - *Open split*, gaps i < j. The first arc is t_i … t_{j-1}; the second is t_j … t_{k-1}, the boundary's letter, t_0 …
//   t_{i-1}, either part perhaps empty. Then as for a split. In path order the edges are the edges of the second arc
//   after that letter without the first one, the edges of the first arc, and the edges of the second arc before the
//   letter without the last one: no edge is next to the boundary, and the cases found have it dashed.
// - *Boundary split*, gap i. One arc, t_0 … t_{i-1}, A with letter 0, t_i … t_{k-1}; its case is 0: both links lie on
//   the boundary.
// - *Collapse* onto an open fan. One arc, t_0 … t_{k-1}; its case is 0.
//
// In an open fan no bit of `joined` is set for the first solid port, so reading it in another order changes nothing.
//
// **Example.** Split at k = 4, a = 2, ports 0000: both arcs are the letters 0, 0. Their class says that every edge may
// be solid. By the meeting all are, except one edge of the ring of six.
//
// **Complexity.** One table access for each triangle forwards, and one backwards; the accesses backwards do not wait
// for each other, because the classes are known by then. Steps of two or more triangles can be composed from these
// tables at compile time.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace restrip {

/// The automaton. `Number` is std::uint8_t, and there are four letters. Entries that nothing asks for hold 0: `first`
/// and `closed` of arcs with the boundary inside or without triangles, `second` of the empty arc, four bits of `before`
/// for a case that no answer has.
template <class Number, std::size_t Letters, std::size_t Classes, std::size_t Firsts, std::size_t Seconds,
          std::size_t Meetings>
struct ArcAutomaton {
  static constexpr std::size_t letters = Letters;
  static constexpr std::size_t classes = Classes;
  static constexpr std::size_t seconds = Seconds;
  /// The letter of the mesh boundary.
  static constexpr unsigned boundary = Letters - 1;
  /// The bits of a case that say that the right link is solid.
  static constexpr unsigned solid = 3;
  /// What `next` holds where a letter is not allowed: a boundary after a boundary.
  static constexpr Number no_class = (std::numeric_limits<Number>::max)();

  std::array<Number, Letters * Classes> next;           ///< index 4 * class + letter
  std::array<std::uint64_t, Letters * Classes> before;  ///< the same index, four bits for each case after it
  std::array<std::uint8_t, Classes> closed;             ///< the case of an arc whose links meet each other
  std::array<Number, Classes> first;                    ///< row of an arc between A and D
  std::array<Number, Classes> second;                   ///< column of an arc between D and A
  std::array<Number, Firsts * Seconds> meet;            ///< index seconds * row + column, into `meetings`
  std::array<std::uint16_t, Meetings> meetings;         ///< case of the first arc | of the second << 4 | chord << 8
};

}  // namespace restrip
