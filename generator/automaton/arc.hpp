// Arcs: rows of fan triangles between two cuts, and all that the rest of a patch must know of one
// (docs/explanation/automaton.md).
//
// An arc has two links, the dual edges over which its first and its last triangle leave it. Inside the arc the solid
// edges form strands. A strand that enters over a link passes only triangles without a solid port, so it can reach one
// port at most, the solid port nearest to that link. Where it goes is the *reach* of the link; the reaches of both
// links are a *case*. Of all colourings of the arc with the same case only a cheapest one can be part of a cheapest
// recolouring.
//
// Where swaps have a price, a reach also says how the strand turns in the triangle at the link, and a letter how the
// strip turns behind a solid port. Where they have none, turns are not distinguished: the same code, fewer letters.
//
// Which edges an arc counts: its left link and the edges inside it. The right link is the left link of what follows.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace restrip::generator {

/// restart * strips + swap * swaps + isolated * isolated triangles.
struct Weights {
  int restart = 0;
  int swap = 0;
  int isolated = 0;
  friend bool operator==(const Weights&, const Weights&) = default;
};
inline constexpr int largest_weight = 1000;
/// Fewest strips, and of those fewest isolated triangles: so many of these never meet in one comparison that they
/// outweigh a strip (docs/explanation/automaton.md, "Costs").
inline constexpr Weights strips_weights{largest_weight, 0, 1};
/// The length of an index buffer.
inline constexpr Weights index_weights{3, 1, 0};

[[nodiscard]] constexpr bool tells_turns(const Weights& weights) { return weights.swap != 0; }

/// Where the strand over a link goes, on the side of the arc. The end triangle is the one at the link.
enum class Reach : unsigned {
  dashed,  ///< none exists: the link is dashed
  ends,    ///< it ends in the end triangle; where turns are not distinguished, anywhere inside the arc
  port,    ///< it leaves by the port of the end triangle; where turns are not distinguished, by the nearest solid port
  along_ends,  ///< it continues along the fan and ends inside the arc
  along_port,  ///< it continues along the fan and leaves by the solid port nearest to the link
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
[[nodiscard]] constexpr bool right_is_solid(Case c) { return right_of(c) != Reach::dashed; }
[[nodiscard]] constexpr bool leads_to_port(Reach reach) { return reach == Reach::port || reach == Reach::along_port; }

/// The cases that arcs have under these weights, ascending.
[[nodiscard]] std::vector<Case> cases_of(const Weights& weights);

/// A case as certificates write it: one character for each link, of `-epfqt` in the order of Reach.
[[nodiscard]] std::string text_of(Case c);

/// What may be appended to an arc: a triangle, by its port; or the boundary. `left`, `right`: the strip behind the port
/// continues about the corner that the port shares with the triangle's left or right link, so that the port is a swap
/// if the strip uses this link; only where turns are distinguished.
enum class Letter : unsigned {
  dashed,  ///< dashed, or none exists
  ends,    ///< solid, and the strip ends behind it; where turns are not distinguished, solid
  left,
  right,
  joined_ends,  ///< as the three before, and joined to the solid port before it
  joined_left,
  joined_right,
  boundary  ///< the mesh boundary in a ring that stands for an open fan: no edge leads over it
};
[[nodiscard]] constexpr bool has_port(Letter letter) { return letter != Letter::dashed && letter != Letter::boundary; }
[[nodiscard]] constexpr bool is_joined(Letter letter) {
  return letter >= Letter::joined_ends && letter < Letter::boundary;
}

/// The letters under these weights, in the order in which headers and certificates number them.
[[nodiscard]] const std::vector<Letter>& letters_of(const Weights& weights);

/// A letter as certificates write it: `d`, `s`, `l`, `r`, `S`, `L`, `R` or `b`.
[[nodiscard]] char text_of(Letter letter);

/// The least cost of each case, up to what all have in common; nothing where none exists. A strip's restart is
/// counted by what it lacks: each solid edge is worth one.
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

/// Drops every case that can be exchanged for another one without loss, in any patch (docs/explanation/automaton.md,
/// "Exchanges").
[[nodiscard]] Costs without_dispensable(const Costs& costs, const Weights& weights);

}  // namespace restrip::generator
