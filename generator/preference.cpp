#include "preference.hpp"

#include <bit>
#include <cstddef>
#include <vector>

namespace restrip::generator {
namespace {

/// What is counted, and how much one of it weighs. The weights were found by climbing from a guess, one or a few
/// weights at a time, with replays of real meshes from 2 % to 100 % as the judge; docs/tables.md has the figures.
struct Weights {
  int solid_chord;         ///< the chord is solid
  int joined_pair;         ///< two ports are joined inside
  int end_facing_out;      ///< a strip ends at a fan triangle whose port is dashed: it may go on there one day
  int end_at_port;         ///< a strip enters by a port and ends at once
  int end_at_new;          ///< a strip ends at A or D
  int neighbouring_ends;   ///< an inner edge between two strip ends
  int square_of_ports;     ///< for each strip, the square of the fan triangles it covers: long strips
  int solid_at_new;        ///< a solid edge of A or D
  int solid_in_first_arc;  ///< a solid edge between A and D on the side of the first arc
};

constexpr Weights of_local_rules{64, -49, -53, -4, 100, -11, -14, 64, 7};
constexpr Weights of_linked_rules{63, -102, -37, 0, 101, 85, 11, 57, 11};

struct Degrees {
  std::vector<int> inner;
  std::vector<int> all;
};

Degrees degrees(const Side& side, const Coloring& coloring, Mask ports) {
  Degrees d{std::vector<int>(side.nodes, 0), {}};
  for (std::size_t e = 0; e < side.edges.size(); ++e) {
    if ((coloring.inner >> e & 1U) == 0) continue;
    ++d.inner[side.edges[e].u];
    ++d.inner[side.edges[e].v];
  }
  d.all = d.inner;
  for (std::size_t p = 0; p < side.owner.size(); ++p) d.all[side.owner[p]] += (ports >> p & 1U) != 0 ? 1 : 0;
  return d;
}

/// Swaps inside the patch: pairs of neighbours that a strip passes with two turns the same way. Ring and path edges
/// come in order, a chord after them. Along the ring a fan triangle is passed with a left turn and left or entered over
/// its port with a right one; at an inserted triangle, which points outward, it is the other way round, the chord being
/// its port.
int swaps(const Side& after, const Coloring& coloring, Mask ports) {
  const auto fan = static_cast<unsigned>(after.owner.size());
  const bool chord = after.nodes == fan + 2;
  const std::size_t along = after.edges.size() - (chord ? 1 : 0);
  const auto solid = [&](std::size_t e) { return (coloring.inner >> e & 1U) != 0; };
  const bool chord_solid = chord && solid(along);
  std::vector<int> below(after.nodes, 0);
  std::vector<int> above(after.nodes, 0);
  for (std::size_t e = 0; e < along; ++e) above[after.edges[e].u] = below[after.edges[e].v] = solid(e) ? 1 : 0;
  const auto third = [&](unsigned node) { return node < fan ? (ports >> node & 1U) != 0 : chord_solid; };
  const auto passed = [&](unsigned node) { return below[node] + above[node] + (third(node) ? 1 : 0) == 2; };
  const auto left_turn = [&](unsigned node) { return (node < fan) != third(node); };
  int count = 0;
  for (std::size_t e = 0; e < along; ++e) {
    const auto [u, v] = after.edges[e];
    count += solid(e) && passed(u) && passed(v) && left_turn(u) == left_turn(v) ? 1 : 0;
  }
  if (chord_solid && passed(fan) && passed(fan + 1)) count += below[fan] == above[fan + 1] ? 1 : 0;
  return count;
}

}  // namespace

std::int64_t tie_break(const Position& position, const Side& after, const Coloring& coloring, const Outcome& outcome,
                       Mask ports, Sight sight, Goal goal) {
  const Weights& weight = sight == Sight::patch ? of_local_rules : of_linked_rules;
  const bool chord = position.family == Family::split || position.family == Family::open_split;
  const auto fan = static_cast<unsigned>(after.owner.size());
  const Degrees degree = degrees(after, coloring, ports);
  std::int64_t sum = 0;
  for (unsigned node = 0; node < after.nodes; ++node) {
    const bool is_new = node >= fan;
    const bool end = degree.all[node] == 1;
    if (is_new) sum += std::int64_t{weight.solid_at_new} * degree.inner[node] + (end ? weight.end_at_new : 0);
    if (!is_new && end) sum += (ports >> node & 1U) != 0 ? weight.end_at_port : weight.end_facing_out;
  }
  for (const auto& [u, v] : after.edges)
    if (degree.all[u] == 1 && degree.all[v] == 1) sum += weight.neighbouring_ends;
  for (const Mask strip : coloring.strips)
    sum += std::int64_t{weight.square_of_ports} * std::popcount(strip) * std::popcount(strip);
  constexpr std::int64_t above_all = 1000;
  if (goal == Goal::indices && position.family != Family::flip) sum += above_all * swaps(after, coloring, ports);
  sum += std::int64_t{weight.joined_pair} * static_cast<std::int64_t>(outcome.pairs.size());
  if (chord) {
    sum += std::int64_t{weight.solid_chord} * static_cast<int>(coloring.inner >> (after.edges.size() - 1) & 1U);
    const Mask first_arc = (Mask{2} << position.at) - 1;
    sum += std::int64_t{weight.solid_in_first_arc} * std::popcount(coloring.inner & first_arc);
  }
  return sum;
}

}  // namespace restrip::generator
