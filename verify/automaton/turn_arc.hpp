#pragma once
// Arcs under a cost with swaps, by their definition (docs/automaton.md, "The index automaton"): triangles with corners
// in a row, every colouring of the dual edges between them tried, every strand walked. A strip passes a triangle about
// the corner that its two edges there share; a solid edge is a swap when the strip passes both of its triangles about
// the same corner.

#include <array>
#include <compare>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "arc.hpp"
#include "masks.hpp"

namespace restrip::verify {

/// The weights of a strip, of a swap and of an isolated triangle.
struct TurnWeights {
  int restart = 0;
  int swap = 0;
  int isolated = 0;
};

/// The letters: a triangle whose port is dashed; solid, and the strip ends behind it; solid, and the strip goes on
/// about the corner of the port at the left or at the right link. Capitals: joined to the solid port before it.
inline constexpr std::string_view turn_letters = "dslrSLR";
constexpr bool turn_port(char letter) { return letter != 'd'; }
constexpr bool turn_joined(char letter) { return letter >= 'A' && letter <= 'Z'; }

/// What the strands over the two links of an arc do, a character for each: `-` dashed; `e` it ends in the end triangle;
/// `p` it leaves by the port of the end triangle; `f` it goes on along the fan and ends; `q` it goes on along the fan
/// and leaves by a port; `t` it leaves by the other link.
inline constexpr std::string_view turn_reaches = "-epfq";
inline constexpr std::size_t turn_cases = 26;
inline constexpr std::size_t turn_through = 25;
/// Left reach first, in the order above; `tt` is the last one.
constexpr Case turn_case(std::size_t number) {
  if (number == turn_through) return {'t', 't'};
  return {turn_reaches[number / turn_reaches.size()], turn_reaches[number % turn_reaches.size()]};
}
/// The place of a case among all; nullopt for anything else.
std::optional<std::size_t> turn_number(Case c);
/// The case of arcs that forgets how strands turn.
Case without_turns(Case c);

/// By case; nullopt where no colouring has the case.
using TurnCosts = std::array<std::optional<int>, turn_cases>;
/// The least of them; there must be one.
int least_of(const TurnCosts& costs);

/// A colouring of an arc. Its links are bits 0 … of `links`, from the left one to the right one.
struct TurnColoring {
  bool sound = false;  ///< degrees at most two, no ports joined but those that the letters join
  std::size_t arc_case = 0;
  int cost = 0;  ///< the right link is not counted, it is the left link of what follows; a solid edge saves a strip
};
/// With links whose triangles have at most two solid edges the other members are meaningful whatever `sound` says.
TurnColoring turn_coloring(std::string_view word, Mask links, const TurnWeights& weights);

/// The corner about which a strip passes the triangle at a link of an arc, by what its strand does there: the hub, the
/// corner of the rim at the link, or none.
enum class TurnCorner { none, hub, rim };
TurnCorner corner_at_link(char reach);

}  // namespace restrip::verify
