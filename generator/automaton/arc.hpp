// Arcs: rows of fan triangles between two cuts, and all that the rest of a patch must know of one (docs/automaton.md).
//
// An arc has two links, the dual edges over which its first and its last triangle leave it. Inside the arc the solid
// edges form strands. A strand that enters over a link passes only triangles without a solid port, so it can reach one
// port at most, the solid port nearest to that link. So a link has three cases, its *reach*, and there is one more
// where a strand leads from link to link: ten cases in all. Of all colourings of the arc with the same case only a best
// one can be part of a best recolouring.
//
// Which edges an arc counts: its left link and the edges inside it. The right link is the left link of what follows.
#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <optional>
#include <string>

namespace restrip::generator {

/// Where the strand over a link goes, on the side of the arc.
enum class Reach : unsigned {
  dashed,  ///< there is none: the link is dashed
  ends,    ///< it ends inside the arc
  port,    ///< it leaves the arc by the solid port nearest to the link
  through  ///< it leaves the arc by the other link; then this is the reach of both
};

/// A case: the reach of the left link times four plus that of the right one.
using Case = unsigned;
inline constexpr std::size_t case_codes = 16;
[[nodiscard]] constexpr Case case_of(Reach left, Reach right) {
  return 4 * static_cast<unsigned>(left) + static_cast<unsigned>(right);
}
[[nodiscard]] constexpr Reach left_of(Case c) { return static_cast<Reach>(c / 4); }
[[nodiscard]] constexpr Reach right_of(Case c) { return static_cast<Reach>(c % 4); }
inline constexpr Case both_dashed = 0;
inline constexpr Case through_case = case_of(Reach::through, Reach::through);
inline constexpr std::array<Case, 10> all_cases{0, 1, 2, 4, 5, 6, 8, 9, 10, through_case};

/// A case as certificates write it: one letter for each link, `-`, `e`, `p` or `t`.
[[nodiscard]] std::string text_of(Case c);

/// What is best, in the order of docs/notation.md: more solid edges, then fewer isolated triangles.
struct Value {
  int solid = 0;
  int fewer_isolated = 0;  ///< minus the number of isolated triangles
  friend constexpr auto operator<=>(const Value&, const Value&) = default;
  friend constexpr Value operator+(Value x, Value y) {
    return {x.solid + y.solid, x.fewer_isolated + y.fewer_isolated};
  }
  friend constexpr Value operator-(Value x, Value y) {
    return {x.solid - y.solid, x.fewer_isolated - y.fewer_isolated};
  }
};

/// What may be appended to an arc. `boundary` is the mesh boundary in a ring that stands for an open fan: no edge leads
/// over it.
enum class Letter : unsigned {
  dashed,    ///< a triangle whose port is dashed or absent
  separate,  ///< a triangle whose port is solid, and not joined to the solid port before it
  joined,    ///< a triangle whose port is solid and joined to the solid port before it
  boundary
};
inline constexpr std::array<Letter, 4> all_letters{Letter::dashed, Letter::separate, Letter::joined, Letter::boundary};

/// A letter as certificates write it: `d`, `s`, `j` or `b`.
[[nodiscard]] char text_of(Letter letter);

/// The best value of each case; nothing where no colouring has it.
using Values = std::array<std::optional<Value>, case_codes>;

/// The arc without triangles: its two links are one edge, which what follows will count.
[[nodiscard]] Values values_of_empty_arc();

/// An arc with one letter more: its values, and for each case the case before from which the best value comes.
struct Appended {
  Values values;
  std::array<Case, case_codes> before{};
};
[[nodiscard]] Appended append(const Values& arc, Letter letter);

}  // namespace restrip::generator
