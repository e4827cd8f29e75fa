#pragma once
// Arcs by their definition (docs/automaton.md): elements in a row, every colouring of the dual edges between them
// tried, every strand walked.

#include <array>
#include <compare>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "masks.hpp"

namespace restrip::verify {

/// What the strands over the two links of an arc do, a character for each: `-` dashed, `e` it ends inside, `p` it
/// leaves by a port, `t` it leaves by the other link.
struct Case {
  char left = '-';
  char right = '-';
  friend constexpr auto operator<=>(Case, Case) = default;
  std::string text() const { return {left, right}; }
};

inline constexpr std::array<Case, 10> all_cases = {{{'-', '-'},
                                                    {'-', 'e'},
                                                    {'-', 'p'},
                                                    {'e', '-'},
                                                    {'e', 'e'},
                                                    {'e', 'p'},
                                                    {'p', '-'},
                                                    {'p', 'e'},
                                                    {'p', 'p'},
                                                    {'t', 't'}}};

/// The place of a case among all; nullopt for anything else.
std::optional<std::size_t> number_of(Case c);
inline constexpr std::size_t both_dashed = 0;

/// What a colouring is worth, ascending: solid edges first, then fewer isolated triangles.
struct Worth {
  int solid = 0;
  int fewer_isolated = 0;
  friend constexpr auto operator<=>(Worth, Worth) = default;
  friend constexpr Worth operator+(Worth x, Worth y) {
    return {x.solid + y.solid, x.fewer_isolated + y.fewer_isolated};
  }
  friend constexpr Worth operator-(Worth x, Worth y) {
    return {x.solid - y.solid, x.fewer_isolated - y.fewer_isolated};
  }
};

/// By case, in the order of all_cases; nullopt where no colouring has the case.
using Worths = std::array<std::optional<Worth>, all_cases.size()>;

/// The best of them; there must be one.
Worth best_of(const Worths& worths);

/// The letters of arcs: a triangle whose port is dashed, solid, or solid and joined to the solid port before it; and
/// the boundary of the mesh.
inline constexpr std::string_view letters = "dsjb";
inline bool has_boundary(std::string_view word) { return word.find('b') != std::string_view::npos; }

/// A sound colouring of an arc. Its links are bits 0 … of `links`, from the left one to the right one, one more than
/// the arc has letters.
struct ArcColoring {
  Mask links = 0;
  std::size_t arc_case = 0;
  Worth worth;  ///< the right link is not counted, it is the left link of what follows
};

/// Calls `visit` with every sound colouring of the arc: degrees at most two, no edge over the boundary, no ports joined
/// but those that the letters join. A strand that meets a triangle with a solid port leaves by it, as its degree is two
/// then: so from a link it reaches no port but the nearest.
void for_each_coloring(std::string_view word, const std::function<void(const ArcColoring&)>& visit);

/// The best of all colourings, by case.
Worths worths_of(std::string_view word);

/// Where each best colouring of an arc may come from: bit c of `from[d]` is set when some best colouring with case d
/// has case c without its last letter.
struct Origins {
  Worths worths;
  std::array<Mask, all_cases.size()> from{};
};
Origins origins_of(std::string_view word);

}  // namespace restrip::verify
