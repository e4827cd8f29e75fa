// Arcs of a fan under a cost of strips, swaps and isolated triangles (docs/automaton.md, "The index automaton").
// As in arc.hpp, but a case also says how the strand over a link turns in the arc's end triangle: whether the link is a
// swap depends on it.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>

namespace restrip::generator::indices {

/// restart * strips + swap * swaps + isolated * isolated triangles.
struct Weights {
  int restart = 3;
  int swap = 1;
  int isolated = 0;
};
inline constexpr int largest_weight = 1000;

/// Where the strand over a link goes, on the side of the arc. The end triangle is the one at the link.
enum class Reach : unsigned {
  dashed,      ///< there is none: the link is dashed
  ends,        ///< it ends in the end triangle
  port,        ///< it leaves by the port of the end triangle
  along_ends,  ///< it goes on along the fan and ends inside the arc
  along_port,  ///< it goes on along the fan and leaves by the solid port nearest to the link
  through      ///< it leaves the arc by the other link; then this is the reach of both
};

/// A case: the reach of the left link times five plus that of the right one; one code more where both are `through`.
using Case = unsigned;
inline constexpr std::size_t case_codes = 26;
inline constexpr Case both_dashed = 0;
inline constexpr Case through_case = 25;
[[nodiscard]] constexpr Case case_of(Reach left, Reach right) {
  return left == Reach::through ? through_case : 5 * static_cast<unsigned>(left) + static_cast<unsigned>(right);
}
[[nodiscard]] constexpr Reach left_of(Case c) { return static_cast<Reach>(c / 5); }
[[nodiscard]] constexpr Reach right_of(Case c) {
  return c == through_case ? Reach::through : static_cast<Reach>(c % 5);
}

/// A case as certificates write it: one character for each link, of `-epfqt` in the order of Reach.
[[nodiscard]] std::string text_of(Case c);

/// What a triangle's port may be. `left`, `right`: the strip behind the port goes on about the corner that the port
/// shares with the triangle's left or right link, so that the port is a swap if the strip uses this link.
enum class Letter : unsigned {
  dashed,  ///< dashed, or there is none
  ends,    ///< solid, and the strip ends behind it
  left,
  right,
  joined_ends,  ///< as the three before, and joined to the solid port before it
  joined_left,
  joined_right
};
inline constexpr std::array<Letter, 7> all_letters{Letter::dashed,      Letter::ends,        Letter::left,
                                                   Letter::right,       Letter::joined_ends, Letter::joined_left,
                                                   Letter::joined_right};

/// A letter as certificates write it: `d`, `s`, `l`, `r`, `S`, `L`, `R`.
[[nodiscard]] char text_of(Letter letter);

/// The least cost of each case, up to what all have in common; nothing where there is none. An arc counts its left
/// link, the edges inside it and the swaps at its ports; a strip's restart is counted by what it lacks: each solid edge
/// is worth one restart.
using Costs = std::array<std::optional<int>, case_codes>;

/// The arc without triangles: its two links are one edge, which what follows will count.
[[nodiscard]] Costs costs_of_empty_arc();

/// An arc with one letter more: its costs, and for each case the case before from which the least cost comes.
struct Appended {
  Costs costs;
  std::array<Case, case_codes> before{};
};
[[nodiscard]] Appended append_to_empty(Letter letter, const Weights& weights);
[[nodiscard]] Appended append(const Costs& arc, Letter letter, const Weights& weights);

/// What it costs at most, in any patch, to have the second case in place of the first; nothing where it may not be
/// possible (docs/automaton.md, "Exchanges").
[[nodiscard]] std::optional<int> exchange(Case from, Case to, const Weights& weights);

/// Drops every case that can be exchanged for another one without loss.
[[nodiscard]] Costs without_dispensable(const Costs& costs, const Weights& weights);

}  // namespace restrip::generator::indices
