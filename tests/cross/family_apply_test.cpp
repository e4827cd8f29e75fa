// Claim: the table of a family performs the operation on a mesh at each of its positions. examples/own_family.json,
// which removes a vertex of k triangles, is applied at every halfedge of meshes with vertices of all valences. It is
// granted if the triangles, computed on a bare list, are valid afterwards; the mesh then equals the list; and the
// reported strips and isolated triangles are correct. `restrip-generate rules` writes the table. So does an operation
// with the most ports, under every policy.
#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "../runtime/applied_lists.hpp"
#include "../support/random_operations.hpp"
#include "restrip/operations/operations.hpp"
#include "restrip/output/strips.hpp"
#include "restrip/search/keeper.hpp"
#include "restrip/search/policy.hpp"
#include "restrip/search/stripify.hpp"
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

}  // namespace
}  // namespace restrip
