// Claims: the table of a family performs the operation on a mesh at each of its positions. examples/own_family.json,
// which removes a vertex of k triangles, is applied at every halfedge of meshes with vertices of all valences. It is
// granted if the triangles, computed on a bare list, are valid afterwards; the mesh then equals the list; and the
// reported strips and isolated triangles are correct. `restrip-generate rules` writes the table. So does an operation
// with the most ports, under every policy.
//
// For custom families that `restrip-generate automaton --operation` accepts, its look-up is as good as the family's
// table. For every valid configuration of every position up to k = 8, the answer is sound and has the same number of
// solid edges and of isolated triangles as the table's rule. Joined ports are found by following the solid edges of the
// triangles, without the library's keys.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <random>
#include <span>
#include <utility>
#include <vector>

#include "../runtime/applied_lists.hpp"
#include "../runtime/naive_patch.hpp"
#include "../runtime/random_operations.hpp"
#include "restrip/automaton/corner_turns.hpp"
#include "restrip/automaton/fan_becomes_star.hpp"
#include "restrip/operations/operations.hpp"
#include "restrip/output/strips.hpp"
#include "restrip/search/keeper.hpp"
#include "restrip/search/policy.hpp"
#include "restrip/search/stripify.hpp"
#include "restrip/tables/operations/corner_turns.hpp"
#include "restrip/tables/operations/fan_becomes_star.hpp"
#include "restrip/tables/operations/flip_in_twelve.hpp"
#include "restrip/tables/operations/remove_vertex.hpp"

namespace restrip {
namespace {

using Halfedge = StripMesh::Halfedge;
constexpr auto& family = tables::remove_vertex_rules;
using At = tables::PositionTable<std::uint16_t>;

static_assert(std::is_constructible_v<OperationView, At>);
static_assert(position_of(family, {5}).triangles_before.size() == 5 && position_of(family, {5}).vertices == 6);
static_assert(position_of(family, {8}).triangles_after.size() == 6);
static_assert(position_of(family, {9}).triangles_before.empty() && !rule_of(position_of(family, {9}), 0, 0).valid);
static_assert(rule_of(position_of(family, {6}), 5, 9).colors == rule_of(family, {6}, 5, 9).colors);

unsigned valence(const StripMesh& mesh, Halfedge h) { return static_cast<unsigned>(spoke_count(mesh, mesh.from(h))); }

/// Meshes with vertices of many valences.
std::vector<StripMesh> meshes() {
  std::vector<StripMesh> all;
  for (Vertex k = 3; k <= 9; ++k) all.push_back(sample::double_cone(k));
  std::mt19937 random(7);
  for (const StripMesh& start : {sample::torus(6, 5), sample::rectangle(6, 5), sample::sphere(1)}) {
    all.push_back(start);
    for (int n = 0; n < 60; ++n) checked_flip(all.back(), random_halfedge(all.back(), random));
  }
  return all;
}

TEST(FamilyApply, DoesWhatTheFileSaysAtEveryValence) {
  for (unsigned k = 3; k <= 8; ++k) {
    // A table is granted only at vertices of its valence.
    const At at = position_of(family, {k});
    std::size_t granted = 0;
    for (const StripMesh& mesh : meshes()) granted += try_everywhere(mesh, [&](Halfedge) -> const At& { return at; });
    EXPECT_GT(granted, 0U) << k;
  }
}

TEST(FamilyApply, OfNoPositionIsRefused) {
  for (const StripMesh& mesh : meshes())
    for (Triangle t = 0; t < mesh.triangle_bound(); ++t)
      EXPECT_EQ(check_apply(mesh, position_of(family, {9}), StripMesh::halfedge(t)), Refusal::other_patch);
}

TEST(FamilyApply, IsKeptUnderEveryPolicy) {
  std::mt19937 random(9);
  for (const PolicyRow& row : policies) {
    std::size_t done = 0;
    for (StripMesh mesh : meshes()) {
      stripify(mesh, Effort::fast, Cost::strips());
      Keeper keeper(mesh, row.policy, Cost::strips());
      for (int tries = 0; tries < 2000 && mesh.triangle_count() > 8; ++tries) {
        const Halfedge h = random_halfedge(mesh, random);
        if (!checked_apply(keeper, position_of(family, {valence(mesh, h)}), h)) continue;
        ++done;
        const ColoringReport report = check_coloring(mesh);
        ASSERT_TRUE(report.valid) << row.name;
        ASSERT_EQ(report.strips, keeper.strips()) << row.name;
        ASSERT_EQ(report.isolated, keeper.isolated()) << row.name;
      }
    }
    EXPECT_GT(done, 30U) << row.name;
  }
}

TEST(FamilyApply, TwelvePorts) {
  constexpr auto& table = tables::flip_in_twelve_rules;
  static_assert(table.ports == tables::most_patch_ports);
  for (const StripMesh& start : {sample::torus(9, 7), sample::rectangle(9, 4)}) {
    EXPECT_GT(try_everywhere(
                  start, [&](Halfedge) -> const auto& { return table; }),
              20U);
    for (const PolicyRow& row : policies) {
      StripMesh mesh = start;
      stripify(mesh, Effort::fast, Cost::strips());
      Keeper keeper(mesh, row.policy, Cost::strips());
      std::size_t done = 0;
      for (Triangle t = 0; t < mesh.triangle_bound(); ++t)
        done += checked_apply(keeper, table, mesh.spoke(t % 20)) ? 1U : 0U;
      const ColoringReport report = check_coloring(mesh);
      ASSERT_TRUE(report.valid && done > 0) << row.name;
      ASSERT_EQ(report.strips, keeper.strips()) << row.name;
    }
  }
}

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
