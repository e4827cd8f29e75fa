// Custom operations work like the shipped ones: strips, swaps and isolated triangles change as reported
// under every policy and either cost.
#include <gtest/gtest.h>

#include <random>

#include "../../support/sanitizers.hpp"
#include "coloring_cost.hpp"
#include "locator_agrees.hpp"
#include "own_operations.hpp"
#include "restrip/operations/apply.hpp"
#include "restrip/output/strips.hpp"
#include "restrip/search/keeper.hpp"
#include "restrip/search/stripify.hpp"
#include "sample_meshes.hpp"
#include "whole_mesh.hpp"

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
          Rewrite reported = stir(keeper, mesh, random, 2 * start.triangle_count()).rewrite;
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

}  // namespace
}  // namespace restrip
