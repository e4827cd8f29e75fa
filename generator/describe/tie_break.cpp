#include "describe/tie_break.hpp"

#include <cstddef>
#include <cstdint>

namespace restrip::generator {
namespace {

/// The counted features and their weights. The weights were found by hill climbing from a guess, one or a few weights
/// at a time, judged by replays of real meshes from 2 % to 100 %; docs/reference/tables.md has the figures.
struct TieWeights {
  int solid_chord;         ///< the chord is solid
  int joined_pair;         ///< two ports are joined inside
  int end_facing_out;      ///< a strip ends at a fan triangle with a dashed port, where it may continue later
  int end_at_port;         ///< a strip enters by a port and ends at once
  int end_at_new;          ///< a strip ends at A or D
  int neighbouring_ends;   ///< an inner edge between two strip ends
  int square_of_ports;     ///< for each strip, the square of the fan triangles it covers: favours long strips
  int solid_at_new;        ///< a solid edge of A or D
  int solid_in_first_arc;  ///< a solid edge between A and D on the side of the first arc
};

constexpr TieWeights weight{64, -49, -53, -4, 100, -11, -14, 64, 7};

/// Inner edges with this many ends among the nodes.
Mask edges_at(const Side& side, Mask nodes, int ends) {
  Mask edges = 0;
  for (std::size_t e = 0; e < side.edges.size(); ++e)
    if (static_cast<int>(nodes >> side.edges[e].u & 1U) + static_cast<int>(nodes >> side.edges[e].v & 1U) == ends)
      edges |= Mask{1} << e;
  return edges;
}

}  // namespace

Criterion tie_break(const Position& position, const Side& after) {
  const Description& family = *position.family;
  if (family.own_cost || family.constraint.most_edges != 2) return {};
  // If one of two ports must be given up, either is possible; this has always been the flip's choice.
  if (family.numbers.empty())
    return family.author == Author::restrip ? Criterion{{Count::kept, -1, 0b0101}} : Criterion{};
  Mask fan = 0;
  for (const unsigned owner : after.owner) fan |= Mask{1} << owner;
  const Mask added = ((Mask{1} << after.nodes) - 1) & ~fan;
  Criterion terms{{Count::ends, weight.end_facing_out, fan},
                  {Count::ends_at_port, weight.end_at_port - weight.end_facing_out, fan},
                  {Count::ends, weight.end_at_new, added},
                  {Count::neighbouring_ends, weight.neighbouring_ends},
                  {Count::squares, weight.square_of_ports},
                  {Count::joined, weight.joined_pair},
                  {Count::solid, weight.solid_at_new, edges_at(after, added, 1)},
                  {Count::solid, 2 * std::int64_t{weight.solid_at_new}, edges_at(after, added, 2)}};
  if (const auto* side = std::get_if<Fan>(&family.after); side != nullptr && side->chord) {
    const Mask chord = Mask{1} << (after.edges.size() - 1);
    const Mask first_arc = (Mask{2} << position.at) - 1;
    terms.push_back({Count::solid, weight.solid_chord, chord});
    terms.push_back({Count::solid, weight.solid_in_first_arc, first_arc});
  }
  return terms;
}

Operation operation_of_rows(const Position& position) {
  Operation operation = operation_at(position, patch_of_rows(position));
  operation.tie_break = tie_break(position, operation.patch.after);
  return operation;
}

}  // namespace restrip::generator
