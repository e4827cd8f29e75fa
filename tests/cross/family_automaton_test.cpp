// Claim: for custom families that `restrip-generate automaton --operation` accepts, its look-up is as good as the
// family's table. For every valid configuration of every position up to k = 8, the answer is sound and has the same
// number of solid edges and of isolated triangles as the table's rule. Joined ports are found by following the solid
// edges of the triangles, without the library's keys.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "../runtime/naive_patch.hpp"
#include "restrip/automaton/corner_turns.hpp"
#include "restrip/automaton/fan_becomes_star.hpp"
#include "restrip/tables/operations/corner_turns.hpp"
#include "restrip/tables/operations/fan_becomes_star.hpp"

namespace restrip {
namespace {

/// One side of a table's patch.
naive::Patch patch_of(std::span<const tables::PatchTriangle> triangles, unsigned inner_edges, unsigned ports,
                      bool cyclic) {
  naive::Patch patch;
  patch.nodes = triangles.size();
  patch.cyclic = cyclic;
  patch.port_node.resize(ports, triangles.size());
  std::vector<std::vector<std::size_t>> ends(inner_edges);
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (const unsigned side : triangles[t].side)
      if (side < inner_edges)
        ends[side].push_back(t);
      else if (side != tables::PatchTriangle::boundary_side)
        patch.port_node.at(side - tables::PatchTriangle::port_side) = t;
  for (const auto& pair : ends) patch.edges.emplace_back(pair.at(0), pair.at(1));
  EXPECT_EQ(std::count(patch.port_node.begin(), patch.port_node.end(), patch.nodes), 0) << "a port of no triangle";
  return patch;
}

/// Where the triangles of a fan lie after the operation.
struct Shape {
  bool cyclic = false;      ///< in the key the first solid port follows the last
  std::size_t first = 0;    ///< the port of the first triangle
  std::size_t between = 0;  ///< the number of edges between them
};

/// The configurations of one position; look_up(ports, joined) asks the automaton.
template <class Table, class LookUp>
std::size_t compare(const Table& table, const Shape& shape, LookUp&& look_up) {
  const unsigned n = table.ports;
  const naive::Patch patch_before = patch_of(table.triangles_before, table.before.edges, n, shape.cyclic);
  const naive::Patch patch_after = patch_of(table.triangles_after, table.after.edges, n, shape.cyclic);
  // Edge i of the fan after lies between the triangles of ports i and i + 1, counted from the first.
  std::vector<std::size_t> edge_of_fan;
  for (std::size_t port = shape.first; port < shape.first + shape.between; ++port) {
    const auto ends = std::minmax({patch_after.port_node[port % n], patch_after.port_node[(port + 1) % n]});
    for (std::size_t edge = 0; edge < patch_after.edges.size(); ++edge)
      if (patch_after.edges[edge] == ends) edge_of_fan.push_back(edge);
  }
  EXPECT_EQ(edge_of_fan.size(), patch_after.edges.size());

  std::size_t compared = 0;
  for (std::uint32_t inner = 0; inner < 1U << patch_before.edges.size(); ++inner)
    for (std::uint32_t ports = 0; ports < 1U << n; ++ports) {
      SCOPED_TRACE(testing::Message() << inner << ' ' << ports);
      const naive::Bits solid_ports = naive::bits_of(ports, n);
      const auto before = naive::analyze(patch_before, naive::bits_of(inner, patch_before.edges.size()), solid_ports);
      const tables::OperationRule rule = tables::rule_of(table, inner, ports);
      EXPECT_EQ(rule.valid, before.valid);
      if (!rule.valid || !before.valid) continue;
      const exact::Recoloring found =
          look_up(ports, naive::mask_of(naive::key_of(patch_before, solid_ports, before.joined)));
      naive::Bits colors(patch_after.edges.size());
      for (std::size_t i = 0; i < edge_of_fan.size(); ++i) colors[edge_of_fan[i]] = (found.colors >> i & 1U) != 0;
      const auto after = naive::analyze(patch_after, colors, solid_ports);
      const auto by_rule = naive::analyze(patch_after, naive::bits_of(rule.colors, colors.size()), solid_ports);
      EXPECT_EQ(rule.ports, ports);
      EXPECT_TRUE(after.valid && by_rule.valid);
      EXPECT_TRUE(naive::subset(after.joined, before.joined));
      EXPECT_EQ(after.solid, by_rule.solid);
      EXPECT_EQ(after.isolated, by_rule.isolated);
      EXPECT_EQ(found.value.solid, after.solid);
      EXPECT_EQ(found.value.isolated, after.isolated);
      ++compared;
    }
  return compared;
}

TEST(FamilyAutomaton, OfAClosedFanIsAsGoodAsItsTable) {
  std::size_t compared = 0;
  for (unsigned k = 3; k <= 8; ++k)
    compared += compare(position_of(tables::fan_becomes_star_rules, {k}), {true, 0, k},
                        [&](Word ports, Word joined) { return exact::best_of_fan_becomes_star(k, ports, joined); });
  EXPECT_GT(compared, 1000U);
}

TEST(FamilyAutomaton, OfAnOpenFanIsAsGoodAsItsTable) {
  std::size_t compared = 0;
  for (unsigned n = 2; n <= 8; ++n)
    compared += compare(position_of(tables::corner_turns_rules, {n, 0}), {false, 0, n - 1},
                        [&](Word ports, Word joined) { return exact::best_of_corner_turns(n, 0, ports, joined); });
  EXPECT_GT(compared, 1000U);
}

// Far beyond tables, by bit strings.
TEST(FamilyAutomaton, AnswersAnyLength) {
  constexpr std::size_t k = 1000;
  std::array<Word, k / 64 + 1> ports{};
  std::array<Word, k / 64 + 1> joined{};
  std::array<Word, k / 64 + 1> colors{};
  ports[0] = 1;
  // A strip that enters over the only solid port can go all around, except over the edge that would close it.
  const exact::Value value =
      exact::best_of_fan_becomes_star(k, BitSpan{ports.data()}, BitSpan{joined.data()}, MutableBitSpan{colors.data()});
  EXPECT_EQ(value.solid, static_cast<int>(k) - 1);
  EXPECT_EQ(value.isolated, 0);
}

}  // namespace
}  // namespace restrip
