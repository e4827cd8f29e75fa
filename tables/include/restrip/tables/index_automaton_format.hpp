// How the generated index automaton (restrip/tables/index_automaton.hpp) is laid out: the rules of every fan, whatever
// its valence, under the cost restart * strips + swap * swaps + isolated * isolated triangles. docs/automaton.md says
// why it exists and how it is checked; docs/notation.md numbers the bits. What follows is all that a look-up needs.
//
// **Arcs.** A cut through two dual edges of a fan leaves an *arc*, a row of triangles between a left and a right
// *link*. It is read from left to right, one *letter* for each triangle t_i:
//
//     0  its port is dashed, or it has none
//     1  its port is solid, and the strip ends behind it
//     2  its port is solid, and behind it the strip goes on about the corner that the port shares with the left link
//     3  the same with the right link
//     4, 5, 6  as 1, 2, 3, where the bit of the port in the key's `joined` is 1
//
// Reading starts in class 0, the empty arc; the cost of the arc's best case is the sum of the letters' costs:
//
//     entry = 7 * class + letter;  cost += move_costs[move[entry]];  class = next[entry]
//
// **Cases.** What a colouring of the arc does at its two links is a *case*: five times the reach of the left link plus
// the reach of the right one, or 25. A reach says where the strand over the link goes on the arc's side; the end
// triangle is the one at the link:
//
//     0  nowhere, the link is dashed
//     1  it ends in the end triangle
//     2  it leaves by the port of the end triangle
//     3  it goes on along the fan and ends inside the arc
//     4  it goes on along the fan and leaves by the solid port nearest to the link
//     case 25: it goes through to the other link, passing all triangles along the fan
//
// Class c has the cases cases[n], n = first[c] … first[c + 1] - 1, ascending, which cost costs[n] more than the best of
// them. Cases that are not listed are never needed. An arc counts its left link, the edges inside it, and the swaps
// inside it and at its ports; each solid edge counts minus `restart`, as it saves a strip.
//
// Once the place p of the whole arc's case among those of its class is known, the colours are read backwards, letter by
// letter. With m = move[entry] of the last letter, bit p of links[m] is the colour of the link to the left of the last
// triangle, and
//
//     p = origins[m] >> 4 * p & 15
//
// the place of the case without the last letter.
//
// **How arcs meet.** For two arcs around A and D, all pairs of their cases are tried, with and without the chord. In
// ring order A, first, D, second, the first arc's left link and the second arc's right link meet in A. What that adds,
// besides `restart` less for the chord and for the right link of each arc, if solid, and `isolated` for A and for D if
// they are, is a `swap` for
//
//     each link of A, and of D, if the strip passes A from link to link and the reach there is 2,
//     the same if the strip passes A from link to chord and the reach is 3 or more,
//     the chord, if the strip passes A and D from links of the same arc.
//
// The arcs of each operation are those of restrip/tables/automaton_format.hpp; but the boundary of an open fan is no
// letter: what lies before and behind it are two arcs, whose links at the boundary are dashed. A boundary split is two
// arcs around A alone, a collapse onto a closed fan one arc whose links are the same edge: a swap if its reaches are
// both 2 or both 3 or more.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace restrip {

/// The automaton. `Classes` is at most 9362; `Entries` counts the cases of all classes.
template <std::size_t Classes, std::size_t Entries, std::size_t Moves>
struct IndexAutomaton {
  static constexpr std::size_t classes = Classes;

  std::uint16_t restart;   ///< cost of each strip
  std::uint16_t swap;      ///< of each swap
  std::uint16_t isolated;  ///< of each isolated triangle, beside the restart of the strip that it is

  std::array<std::uint16_t, 7 * Classes> next;  ///< index 7 * class + letter
  std::array<std::uint16_t, 7 * Classes> move;  ///< index 7 * class + letter, into the next three
  std::array<std::uint64_t, Moves> origins;     ///< four bits for each case after the letter
  std::array<std::uint16_t, Moves> links;       ///< a bit for each case after the letter
  std::array<std::int16_t, Moves> move_costs;
  std::array<std::uint16_t, Classes + 1> first;  ///< by class, into the next two
  std::array<std::uint8_t, Entries> cases;
  std::array<std::uint8_t, Entries> costs;
};

}  // namespace restrip
