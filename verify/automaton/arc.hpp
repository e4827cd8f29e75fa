// Arcs by their definition (docs/explanation/automaton.md): triangles in a row; every colouring of the dual edges
// between them is tried, and every strand walked.
#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "model/masks.hpp"

namespace restrip::verify {

/// Costs: fewest strips, then fewest isolated triangles.
inline constexpr int strip_cost = 1000;
inline constexpr int isolated_cost = 1;

/// The letters of arcs: a triangle whose port is dashed; solid; solid and joined to the solid port before it; and the
/// boundary of the mesh.
inline constexpr std::string_view letters = "dsSb";
constexpr bool is_boundary(char letter) { return letter == 'b'; }
constexpr bool has_port(char letter) { return letter != 'd' && !is_boundary(letter); }
constexpr bool is_joined(char letter) { return letter == 'S'; }
inline bool has_boundary(std::string_view word) { return word.find('b') != std::string_view::npos; }
/// The letters of the solid ports of an arc.
std::string ports_in(std::string_view word);
/// The properties of an arc's ports that determine which pairs of end ports are joined before, whatever the other arc:
/// their number, up to three; whether the first is joined to the one before it; whether there are two and they are
/// joined.
std::string end_ports(std::string_view word);

/// The strands over the two links of an arc, a character for each: `-`: dashed; `e`: ends inside the arc; `p`: leaves
/// by a port; `t`: leaves by the other link.
struct Case {
  char left = '-';
  char right = '-';
  friend constexpr auto operator<=>(Case, Case) = default;
  std::string text() const { return {left, right}; }
};

/// Cases are numbered by left reach first, in the order of `reaches`; `tt` comes last.
inline constexpr std::string_view reaches = "-ep";
inline constexpr std::size_t case_count = 10;
inline constexpr std::size_t both_dashed = 0;
inline constexpr std::size_t through = 9;
constexpr Case case_at(std::size_t number) {
  if (number == through) return {'t', 't'};
  return {reaches[number / reaches.size()], reaches[number % reaches.size()]};
}
/// The number of a case; nullopt for anything else.
std::optional<std::size_t> number_of(Case c);

/// By case; nullopt if no colouring has the case.
using Costs = std::array<std::optional<int>, case_count>;
/// The least cost; at least one must exist.
int least_of(const Costs& costs);

/// A colouring of an arc. Its links are bits 0 … of `links`, from left to right, one more than the letters of the arc.
struct ArcColoring {
  bool sound = false;  ///< degrees at most two, no edge over the boundary, only ports joined that the letters join
  std::size_t arc_case = 0;
  /// The right link is not counted: it is the left link of the next arc. A solid edge saves a strip.
  int cost = 0;
};
/// The other members are undefined for a colouring that is not sound.
ArcColoring arc_coloring(std::string_view word, Mask links);

}  // namespace restrip::verify
