// Arcs: rows of fan triangles between two cuts, and all that the rest of a patch must know of an arc
// (docs/explanation/automaton.md).
//
// An arc has two links, the dual edges by which its first and its last triangle are connected to the rest. Inside the
// arc the solid edges form strands. A strand that enters over a link passes only triangles without a solid port, so it
// can reach at most one port, the solid port nearest to that link. Its destination is the *reach* of the link; the
// reaches of both links are a *case*. Of all colourings of the arc with the same case, only a cheapest one can be part
// of a cheapest recolouring.
//
// An arc counts its left link and the edges inside it. The right link is the left link of the next arc.
#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace restrip::generator {

/// The cost: strip_cost * strips + isolated_cost * isolated triangles. This means fewest strips, then fewest isolated
/// triangles: a comparison involves too few isolated triangles to outweigh a strip (docs/explanation/automaton.md,
/// "Costs").
inline constexpr int strip_cost = 1000;
inline constexpr int isolated_cost = 1;

/// The destination of the strand over a link, on the side of the arc.
enum class Reach : unsigned {
  dashed,  ///< no strand: the link is dashed
  ends,    ///< it ends inside the arc
  port,    ///< it leaves by the nearest solid port
  through  ///< it leaves the arc by the other link; then both links have this reach
};

/// A case: four times the reach of the left link plus the reach of the right one, as headers number it.
using Case = unsigned;
inline constexpr std::size_t case_codes = 16;
inline constexpr Case both_dashed = 0;
[[nodiscard]] constexpr Case case_of(Reach left, Reach right) {
  return 4 * static_cast<unsigned>(left) + static_cast<unsigned>(right);
}
inline constexpr Case through_case = case_of(Reach::through, Reach::through);
[[nodiscard]] constexpr Reach left_of(Case c) { return static_cast<Reach>(c / 4); }
[[nodiscard]] constexpr Reach right_of(Case c) { return static_cast<Reach>(c % 4); }

/// The codes that are cases, ascending: either both links go through, or neither.
inline constexpr std::array<Case, 10> all_cases{0, 1, 2, 4, 5, 6, 8, 9, 10, through_case};

/// A case as certificates write it: one character for each link, of `-ept` in the order of Reach.
[[nodiscard]] std::string text_of(Case c);

/// What can be appended to an arc: a triangle, by its port; or the boundary. Headers and certificates use these
/// numbers.
enum class Letter : unsigned {
  dashed,   ///< dashed, or no port
  solid,    ///< solid
  joined,   ///< solid, and joined to the solid port before it
  boundary  ///< the mesh boundary in a ring that stands for an open fan: no edge crosses it
};
inline constexpr std::array<Letter, 4> all_letters{Letter::dashed, Letter::solid, Letter::joined, Letter::boundary};
[[nodiscard]] constexpr bool has_port(Letter letter) { return letter == Letter::solid || letter == Letter::joined; }

/// A letter as certificates write it: `d`, `s`, `S` or `b`.
[[nodiscard]] char text_of(Letter letter);

/// The least cost of each case, up to a common constant; empty if the case does not exist. Restarts of strips are
/// counted by their absence: each solid edge is worth one.
using Costs = std::array<std::optional<int>, case_codes>;

/// An arc with one more letter: its costs, and for each case the previous case from which the least cost comes.
struct Appended {
  Costs costs;
  std::array<Case, case_codes> before{};
};
[[nodiscard]] Appended append(const Costs& arc, Letter letter);

// Two arcs around A and D, or one arc around a fan: the best combination of their cases
// (docs/explanation/automaton.md).

/// The properties of an arc's solid ports that determine which pairs of end ports are pairs of the key.
struct Ports {
  unsigned count = 0;         ///< 3 stands for three or more
  bool first_joined = false;  ///< the first one is joined to the solid port before it, which lies outside the arc
  bool two_joined = false;    ///< it has exactly two, and they are joined
  friend constexpr auto operator<=>(const Ports&, const Ports&) = default;
};
[[nodiscard]] Ports with_letter(Ports ports, Letter letter);

/// An arc with all cases that some patch may need; costs minus the least.
struct Arc {
  Costs costs;
  Ports ports;
  bool boundary = false;  ///< the mesh boundary is inside
  friend auto operator<=>(const Arc&, const Arc&) = default;
};

/// The choice for two arcs around A and D, in ring order A, first, D, second.
struct Meeting {
  Case first = both_dashed;
  Case second = both_dashed;
  bool chord = false;
};

/// All meetings that are sound for some arcs, in order of preference, and the best of them for two arcs.
class Meetings {
 public:
  Meetings();

  [[nodiscard]] const Meeting& operator[](std::size_t number) const { return combinations_[number].meeting; }
  /// Its number.
  [[nodiscard]] std::size_t best(const Arc& first, const Arc& second) const;

 private:
  struct Combination {
    Meeting meeting;
    int cost = 0;        ///< the cost of A, D and the edges that no arc counts
    unsigned joins = 0;  ///< pairs of ends whose strands reach ports and are joined
    int tie = 0;         ///< smaller is preferred
  };
  static std::optional<Combination> combination_of(const Meeting& meeting);

  std::vector<Combination> combinations_;
};

/// The best case of an arc that is a whole closed fan, so that its two links are one edge.
[[nodiscard]] Case best_closing(const Arc& arc);

}  // namespace restrip::generator
