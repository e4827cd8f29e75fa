// Claim: for custom families that `restrip-generate automaton --operation` accepts, its look-up is as good as the
// family's table. For every valid configuration of every position up to k = 8, the answer is sound and has the same
// number of solid edges and of isolated triangles as the table's rule. Joined ports are found by following the solid
// edges of the triangles, without the library's keys.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <numeric>
#include <optional>
#include <span>
#include <vector>

#include "restrip/automaton/corner_turns.hpp"
#include "restrip/automaton/fan_becomes_star.hpp"
#include "restrip/tables/operations/corner_turns.hpp"
#include "restrip/tables/operations/fan_becomes_star.hpp"

namespace restrip {
namespace {

using tables::PatchTriangle;

/// A patch with some of its edges solid.
struct Patch {
  std::span<const PatchTriangle> triangles;
  unsigned inner_edges = 0;
  unsigned ports = 0;

  [[nodiscard]] unsigned owner(unsigned port) const {
    for (unsigned t = 0; t < triangles.size(); ++t)
      for (const unsigned side : triangles[t].side)
        if (side == PatchTriangle::port_side + port) return t;
    ADD_FAILURE() << "no port " << port;
    return 0;
  }
  [[nodiscard]] std::vector<unsigned> triangles_at(unsigned edge) const {
    std::vector<unsigned> at;
    for (unsigned t = 0; t < triangles.size(); ++t)
      if (std::count(triangles[t].side.begin(), triangles[t].side.end(), edge) != 0) at.push_back(t);
    return at;
  }
  [[nodiscard]] int solid_edges_of(unsigned t, std::uint32_t inner, std::uint32_t solid_ports) const {
    int solid = 0;
    for (const unsigned side : triangles[t].side) {
      const bool is_port = side >= PatchTriangle::port_side && side != PatchTriangle::boundary_side;
      if (side < inner_edges) solid += static_cast<int>(inner >> side & 1U);
      if (is_port) solid += static_cast<int>(solid_ports >> (side - PatchTriangle::port_side) & 1U);
    }
    return solid;
  }
  [[nodiscard]] int isolated(std::uint32_t inner, std::uint32_t solid_ports) const {
    int isolated = 0;
    for (unsigned t = 0; t < triangles.size(); ++t) isolated += solid_edges_of(t, inner, solid_ports) == 0 ? 1 : 0;
    return isolated;
  }
  /// For each triangle, the smallest one that solid edges connect with it; empty if they close a cycle or a triangle
  /// has three.
  [[nodiscard]] std::optional<std::vector<unsigned>> strips(std::uint32_t inner, std::uint32_t solid_ports) const {
    std::vector<unsigned> strip(triangles.size());
    std::iota(strip.begin(), strip.end(), 0U);
    for (unsigned edge = 0; edge < inner_edges; ++edge) {
      if ((inner >> edge & 1U) == 0) continue;
      const std::vector<unsigned> at = triangles_at(edge);
      const unsigned one = strip[at[0]];
      const unsigned other = strip[at[1]];
      if (one == other) return {};
      std::replace(strip.begin(), strip.end(), std::max(one, other), std::min(one, other));
    }
    for (unsigned t = 0; t < triangles.size(); ++t)
      if (solid_edges_of(t, inner, solid_ports) > 2) return {};
    return strip;
  }
};

/// Where the triangles of a fan lie after the operation.
struct Shape {
  bool cyclic = false;      ///< in the key the first solid port follows the last
  std::size_t first = 0;    ///< the port of the first triangle
  std::size_t between = 0;  ///< the number of edges between them
};

/// The configurations of one position; look_up(ports, joined) asks the automaton.
template <class Table, class LookUp>
std::size_t compare(const Table& table, const Shape& shape, LookUp&& look_up) {
  const Patch before{table.triangles_before, table.before.edges, table.ports};
  const Patch after{table.triangles_after, table.after.edges, table.ports};
  const unsigned n = table.ports;
  // Edge i of the fan after lies between the triangles of ports i and i + 1, counted from the first.
  std::vector<unsigned> edge_of_fan;
  for (unsigned i = 0; i < shape.between; ++i)
    for (unsigned edge = 0; edge < after.inner_edges; ++edge) {
      const auto port = static_cast<unsigned>(i + shape.first);
      std::vector<unsigned> ends{after.owner(port % n), after.owner((port + 1) % n)};
      std::sort(ends.begin(), ends.end());
      if (after.triangles_at(edge) == ends) edge_of_fan.push_back(edge);
    }
  EXPECT_EQ(edge_of_fan.size(), after.inner_edges);

  std::size_t compared = 0;
  for (std::uint32_t inner = 0; inner < 1U << before.inner_edges; ++inner)
    for (std::uint32_t ports = 0; ports < 1U << n; ++ports) {
      const tables::OperationRule rule = tables::rule_of(table, inner, ports);
      const auto strips = before.strips(inner, ports);
      EXPECT_EQ(rule.valid, strips.has_value());
      if (!rule.valid || !strips) continue;
      Word joined = 0;
      const auto joins = [&](unsigned p, unsigned q) {
        return (*strips)[before.owner(p)] == (*strips)[before.owner(q)];
      };
      for (unsigned i = 0; i < n; ++i) {
        if ((ports >> i & 1U) == 0) continue;
        unsigned earlier = i;
        do earlier = (earlier + n - 1) % n;
        while ((ports >> earlier & 1U) == 0);
        if (earlier != i && (shape.cyclic || earlier < i) && joins(i, earlier)) joined |= Word{1} << i;
      }
      const exact::Recoloring found = look_up(ports, joined);
      std::uint32_t colors = 0;
      for (unsigned i = 0; i < edge_of_fan.size(); ++i)
        colors |= static_cast<std::uint32_t>(found.colors >> i & 1U) << edge_of_fan[i];
      EXPECT_EQ(rule.ports, ports) << inner << ' ' << ports;
      EXPECT_EQ(std::popcount(colors), std::popcount(rule.colors)) << inner << ' ' << ports;
      EXPECT_EQ(after.isolated(colors, ports), after.isolated(rule.colors, ports)) << inner << ' ' << ports;
      EXPECT_EQ(found.value.solid, std::popcount(colors));
      EXPECT_EQ(found.value.isolated, after.isolated(colors, ports));
      const auto made = after.strips(colors, ports);
      EXPECT_TRUE(made.has_value());
      if (!made) continue;
      for (unsigned p = 0; p < n; ++p)
        for (unsigned q = 0; q < p; ++q)
          if ((ports >> p & ports >> q & 1U) != 0) {
            const bool are_joined = (*made)[after.owner(p)] == (*made)[after.owner(q)];
            EXPECT_TRUE(!are_joined || joins(p, q)) << inner << ' ' << ports << ": joins " << p << " and " << q;
          }
      ++compared;
    }
  return compared;
}

TEST(FamilyAutomaton, OfAClosedFanIsAsGoodAsItsTable) {
  std::size_t compared = 0;
  for (unsigned k = 3; k <= 8; ++k)
    compared += compare(position_of(tables::fan_becomes_star, {k}), {true, 0, k},
                        [&](Word ports, Word joined) { return exact::best_fan_becomes_star(k, ports, joined); });
  EXPECT_GT(compared, 1000U);
}

TEST(FamilyAutomaton, OfAnOpenFanIsAsGoodAsItsTable) {
  std::size_t compared = 0;
  for (unsigned n = 2; n <= 8; ++n)
    compared += compare(position_of(tables::corner_turns, {n, 0}), {false, 0, n - 1},
                        [&](Word ports, Word joined) { return exact::best_corner_turns(n, 0, ports, joined); });
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
      exact::best_fan_becomes_star(k, BitSpan{ports.data()}, BitSpan{joined.data()}, MutableBitSpan{colors.data()});
  EXPECT_EQ(value.solid, static_cast<int>(k) - 1);
  EXPECT_EQ(value.isolated, 0);
}

}  // namespace
}  // namespace restrip
