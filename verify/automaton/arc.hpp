// Arcs by their definition (docs/explanation/automaton.md): triangles in a row; every colouring of the dual edges
// between them is tried, and every strand walked.
#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

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

// Two arcs around A and D as a small graph. Each arc is represented by its case: a strand over each solid link that
// ends, leaves by a port or goes through. Also one arc whose links meet each other.

/// The links of two arcs in ring order A, first arc, D, second arc.
enum ArcEnd : unsigned { first_left, first_right, second_left, second_right };

/// A combination of two cases.
struct ArcWay {
  bool legal = false;  ///< degrees at most two, no cycle
  int cost = 0;        ///< cost not counted in the arcs
  Mask joined = 0;     ///< pairs of links whose strands leave by ports and are joined
};

/// All combinations of arcs. Cases by number.
class ArcWays {
 public:
  ArcWays();

  /// Around A and D, in ring order A, first, D, second.
  const ArcWay& around(std::size_t first, std::size_t second, bool chord) const {
    return around_[2 * (case_count * first + second) + (chord ? 1U : 0U)];
  }
  /// A closed fan: the two links of an arc are one edge.
  const ArcWay& closed(std::size_t arc_case) const { return closed_[arc_case]; }

 private:
  std::vector<ArcWay> around_;
  std::vector<ArcWay> closed_;
};

/// Whether, in the ring A, first, D, second of these letters, the ports that two links reach are joined before the
/// operation. A solid port may be joined to the solid port before it in the ring, according to its letter.
bool joined_before(std::string_view first, std::string_view second, ArcEnd one, ArcEnd other);
/// All pairs of links for which that is true.
Mask pairs_joined_before(std::string_view first, std::string_view second);

}  // namespace restrip::verify
