// Custom operations work like the shipped ones: strips, swaps and isolated triangles change as reported
// under every policy and either cost, and a mesh that is not ours comes out as a StripMesh does.
#include <gtest/gtest.h>

#include <array>
#include <map>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include "../../support/half_edge_mesh.hpp"
#include "../../support/sanitizers.hpp"
#include "coloring_cost.hpp"
#include "locator_agrees.hpp"
#include "own_operations.hpp"
#include "restrip/operations/apply.hpp"
#include "restrip/operations/join.hpp"
#include "restrip/output/strips.hpp"
#include "restrip/search/keeper.hpp"
#include "restrip/search/stripify.hpp"
#include "sample_meshes.hpp"

namespace restrip {
namespace {

using Halfedge = StripMesh::Halfedge;

// Under a keeper, reported changes are counted as well, and its locator follows; under every policy and either cost.
TEST(KeptApply, KeepersFollow) {
  std::mt19937 random(7);
  for (const PolicyRow& row : policies)
    for (const Cost& cost : {Cost::strips(), Cost::indices(), Cost{3, 1, 2}})
      for (const StripMesh& start : {sample::torus(8, 7), sample::rectangle(7, 6)}) {
        StripMesh mesh = start;
        stripify(mesh, Effort::fast, Cost::strips());
        Keeper keeper(mesh, row.policy, cost);
        if (row.policy == Policy::local && cost == Cost::strips()) join_all(mesh), keeper.rebuild();
        std::size_t done = 0;
        for (std::size_t n = 0; n < test::large(1500); ++n) {
          if (row.policy == Policy::bare && n % 8 == 0) stripify(mesh, Effort::fast, Cost::strips()), keeper.rebuild();
          ColoringChange change = cost_of(mesh);
          Rewrite<Halfedge> reported = stir(keeper, mesh, random, 2 * start.triangle_count()).rewrite;
          random_application(mesh, random, 3 * start.triangle_count(), [&](const auto& table, Halfedge h) {
            const auto rewrite = keeper.apply(table, h);
            reported.strips += rewrite.strips;
            reported.isolated += rewrite.isolated;
            ++done;
          });
          change = cost_of(mesh) - change;
          ASSERT_EQ(reported.strips, change.strips);
          ASSERT_EQ(reported.isolated, change.isolated);
          ASSERT_EQ(keeper.swaps(), static_cast<std::size_t>(cost_of(mesh).swaps));
          if (n % 8 != 0) continue;
          const ColoringReport counted = check_coloring(mesh);
          ASSERT_TRUE(counted.valid);
          ASSERT_EQ(keeper.strips(), counted.strips);
          ASSERT_EQ(keeper.isolated(), counted.isolated);
          if (keeper.locator() != nullptr) {
            ASSERT_TRUE(agrees(*keeper.locator(), mesh));
          }
          if (row.policy == Policy::local && cost == Cost::strips()) {
            // No two ends meet: docs/explanation/theory.md, "What holds for the whole mesh".
            StripMesh copy = mesh;
            ASSERT_EQ(join_all(copy).strips, 0);
          }
        }
        EXPECT_GT(done, test::large(1500) / 40);
      }
}

// ---- a foreign mesh

using half_edge::first_vertex;

/// Red-green refinement by operations that the mesh has: each side of the triangle in the middle is bisected, which
/// leaves one edge to be turned.
template <class Mesh>
auto refining(Mesh& mesh) {
  return [&mesh](const auto& patch) {
    const auto halve = [&](auto h) { return mesh.insert_vertex(detail::split_on_edge(mesh, h)); };
    const auto a_p = halve(patch.side[0][0]);
    const auto c_a = mesh.next(mesh.next(a_p));
    halve(patch.side[0][1]);
    const auto c_r = halve(c_a);
    return mesh.next(mesh.turn_edge(mesh.next(mesh.next(c_r))));  // p - c becomes q - r
  };
}
/// m goes, which is vertex 2 of the file, into a, which is 3.
template <class Mesh>
auto merging(Mesh& mesh) {
  return [&mesh](const auto& patch) { return mesh.next(mesh.opposite(mesh.remove_vertex(patch.between(3, 2)))); };
}

std::set<std::pair<Vertex, Vertex>> solid_edges_of(const half_edge::Mesh& mesh, const std::map<Vertex, Vertex>& names) {
  std::set<std::pair<Vertex, Vertex>> solid;
  const auto name = [&](Vertex v) { return names.contains(v) ? names.at(v) : v - first_vertex; };
  for (Triangle t = 0; t < mesh.triangle_bound(); ++t) {
    auto h = mesh.halfedge(t);
    for (int side = 0; mesh.has_triangle(t) && side < 3; ++side, h = mesh.next(h))
      if (mesh.solid(h)) solid.insert(std::minmax(name(mesh.from(h)), name(mesh.to(h))));
  }
  return solid;
}

// Under every policy and either cost the counts of the keeper are right; by the rules alone, the colours are the same.
TEST(KeptApply, DoesTheSameOnAForeignMesh) {
  std::mt19937 random(8);
  StripMesh mesh = sample::torus(9, 8);
  stripify(mesh, Effort::fast, Cost::strips());
  std::array<std::size_t, 2> compared{};
  const auto compare = [&](std::size_t kind, const auto& table, auto&& change) {
    const auto h = random_place(mesh, table, random);
    if (!h) return;
    const PolicyRow& row = policies[random() % policies.size()];
    const Cost cost = random() % 2 == 0 ? Cost::strips() : Cost::indices();
    half_edge::Mesh foreign = half_edge::copy_of(mesh);
    Keeper<half_edge::Mesh> keeper(foreign, row.policy, cost);
    const auto reported = keeper.apply(table, half_edge::named(foreign, mesh, *h), change(foreign));
    const ColoringReport counted = check_coloring(foreign);
    ASSERT_TRUE(counted.valid);
    ASSERT_EQ(keeper.strips(), counted.strips);
    ASSERT_EQ(keeper.isolated(), counted.isolated);
    ASSERT_EQ(keeper.swaps(), count_swaps(foreign));
    ASSERT_EQ(static_cast<long>(counted.strips), static_cast<long>(count_strips(mesh)) + reported.strips);
    const auto done = apply(mesh, table, *h);
    if (row.policy != Policy::rules || cost != Cost::strips()) return;
    EXPECT_EQ(reported.strips, done.strips);
    EXPECT_EQ(reported.isolated, done.isolated);
    std::map<Vertex, Vertex> names;
    const std::vector<Vertex> theirs = added_vertices(foreign, table, reported.halfedge);
    const std::vector<Vertex> ours = added_vertices(mesh, table, done.halfedge);
    ASSERT_EQ(theirs.size(), ours.size());
    for (std::size_t i = 0; i < ours.size(); ++i) names[theirs[i]] = ours[i];
    EXPECT_EQ(solid_edges_of(foreign, names), solid_edges_of(mesh));
    ++compared[kind];
  };
  for (int n = 0; n < 1200 && !HasFailure(); ++n) {
    stir(mesh, mesh, random, 300);
    if (mesh.triangle_count() < 600)
      compare(0, tables::refine_face_rules, [](half_edge::Mesh& f) { return refining(f); });
    compare(1, tables::merge_rules, [](half_edge::Mesh& f) { return merging(f); });
  }
  EXPECT_GT(compared[0], 40U);
  EXPECT_GT(compared[1], 40U);
}

/// Triangles that are paired stay paired, and those that become single are reported.
TEST(KeptApply, KeepsPairsOnAMeshThatOnlyFlips) {
  std::mt19937 random(10);
  half_edge::OnlyFlips mesh(sample::torus(6, 6));
  const auto solid_sides = [&](auto h) {
    int solid = 0;
    for (int side = 0; side < 3; ++side, h = mesh.next(h)) solid += mesh.solid(h) ? 1 : 0;
    EXPECT_LE(solid, 1);
    return solid;
  };
  const auto random_side = [&] {
    auto h = mesh.halfedge(half_edge::first_triangle + static_cast<Triangle>(random() % 72));
    for (auto turns = random() % 3; turns > 0; --turns) h = mesh.next(h);
    return h;
  };
  const auto count_single = [&] {
    int count = 0;
    for (Triangle t = half_edge::first_triangle; t < mesh.triangle_bound(); ++t)
      count += 1 - solid_sides(mesh.halfedge(t));
    return count;
  };
  for (int n = 0; n < 300; ++n)
    if (const auto h = random_side(); solid_sides(h) + solid_sides(mesh.opposite(h)) == 0) mesh.set_solid(h, true);
  int alone = count_single();
  int flips = 0;
  for (int n = 0; n < 3000; ++n) {
    const auto h = random_side();
    if (detail::refusal_of_flip(mesh, h) != Refusal::granted) continue;
    if (detail::refusal_of_apply(mesh, tables::flip_matching_rules, h) != Refusal::granted) continue;  // meet twice
    const auto done = apply(mesh, tables::flip_matching_rules, h, [&](const auto& patch) {
      // r -> l of (r, l, u); the file begins with l, u, r
      return mesh.next(mesh.turn_edge(patch.side[0][0]));
    });
    alone += done.isolated;
    ASSERT_EQ(count_single(), alone);
    ++flips;
  }
  EXPECT_GT(flips, 500);
}

}  // namespace
}  // namespace restrip
