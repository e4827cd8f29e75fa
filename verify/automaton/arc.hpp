#pragma once
// Arcs by their definition (docs/explanation/automaton.md): triangles with corners in a row, every colouring of the
// dual edges between them tried, every strand walked. A strip passes a triangle about the corner that its two edges
// there share; a solid edge is a swap when the strip passes both of its triangles about the same corner.
//
// Where swaps have no price, turns are not distinguished: there are fewer letters, and fewer cases.

#include <array>
#include <compare>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "model/masks.hpp"

namespace restrip::verify {

/// The weights of a strip, of a swap and of an isolated triangle.
struct Weights {
  int restart = 0;
  int swap = 0;
  int isolated = 0;
  constexpr bool tells_turns() const { return swap != 0; }
  friend bool operator==(const Weights&, const Weights&) = default;
};
/// Fewest strips, then fewest isolated triangles.
inline constexpr Weights strips_weights{1000, 0, 1};

/// The letters of arcs: a triangle whose port is dashed; solid, and the strip ends behind it; solid, and the strip goes
/// on about the corner of the port at the left or at the right link. Capitals: joined to the solid port before it. And
/// the boundary of the mesh. Where turns are not distinguished, `s` and `S` stand for any solid port.
constexpr std::string_view letters_of(const Weights& weights) { return weights.tells_turns() ? "dslrSLRb" : "dsSb"; }
constexpr bool is_boundary(char letter) { return letter == 'b'; }
constexpr bool has_port(char letter) { return letter != 'd' && !is_boundary(letter); }
constexpr bool is_joined(char letter) { return letter >= 'A' && letter <= 'Z'; }
inline bool has_boundary(std::string_view word) { return word.find('b') != std::string_view::npos; }
/// The solid ports of an arc, by the letters that do not tell turns.
std::string ports_in(std::string_view word);
/// What of the ports of an arc says which pairs of end ports are joined before, whatever the other arc: how many there
/// are, up to three; whether the first is joined to the one before it; whether there are two and they are joined.
std::string end_ports(std::string_view word);

/// What the strands over the two links of an arc do, a character for each: `-` dashed; `e` it ends in the end triangle;
/// `p` it leaves by the port of the end triangle; `f` it continues along the fan and ends; `q` it continues along the
/// fan and leaves by a port; `t` it leaves by the other link. Where turns are not distinguished `e` stands for `f` as
/// well, and `p` for `q`.
struct Case {
  char left = '-';
  char right = '-';
  friend constexpr auto operator<=>(Case, Case) = default;
  std::string text() const { return {left, right}; }
};

/// Cases are numbered left reach first, in the order of `reaches`; then comes `tt`.
inline constexpr std::string_view reaches = "-epfq";
inline constexpr std::size_t case_count = 26;
inline constexpr std::size_t both_dashed = 0;
inline constexpr std::size_t through = 25;
constexpr Case case_at(std::size_t number) {
  if (number == through) return {'t', 't'};
  return {reaches[number / reaches.size()], reaches[number % reaches.size()]};
}
/// The place of a case among all; nullopt for anything else.
std::optional<std::size_t> number_of(Case c);
constexpr bool reaches_port(char reach) { return reach == 'p' || reach == 'q'; }

/// By case; nullopt where no colouring has the case.
using Costs = std::array<std::optional<int>, case_count>;
/// The least of them; there must be one.
int least_of(const Costs& costs);
Costs shifted(Costs costs, int by);

/// A colouring of an arc. Its links are bits 0 … of `links`, from the left one to the right one, one more than the arc
/// has letters.
struct ArcColoring {
  bool sound = false;  ///< degrees at most two, no edge over the boundary, no ports joined but those that letters join
  std::size_t arc_case = 0;
  /// The right link is not counted, it is the left link of what follows. A solid edge saves a strip.
  int cost = 0;
};
/// The other members say nothing of a colouring that is not sound.
ArcColoring arc_coloring(std::string_view word, Mask links, const Weights& weights);

/// The corner about which a strip passes the triangle at a link of an arc, by what its strand does there: the hub, the
/// corner of the rim at the link, or none.
enum class ArcCorner { none, hub, rim };
ArcCorner corner_at_link(char reach);

}  // namespace restrip::verify
