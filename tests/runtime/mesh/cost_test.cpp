// A swap is known from four colours where a strip turns around one vertex twice, from either side of the dual edge. The
// other count follows each strip by its vertices (coloring_cost.hpp).
#include "restrip/mesh/cost.hpp"

#include <gtest/gtest.h>

#include <random>

#include "coloring_cost.hpp"
#include "sample_meshes.hpp"

namespace restrip {
namespace {

static_assert(Cost::strips() == Cost{} && Cost::strips().restart == 1 && Cost::strips().swap == 0);
static_assert(Cost::indices().restart == 3 && Cost::indices().swap == 1 && Cost::indices().isolated == 0);

TEST(Swaps, AreTurnsAroundOneVertex) {
  std::mt19937 random(4);
  int all = 0;
  for (const double share : {0.5, 0.9, 1.0})
    for (StripMesh& mesh : sample::manifold_meshes()) {
      sample::color_at_random(mesh, share, random);
      int swaps = 0;
      for (const StripMesh::Halfedge h : sample::sides_of(mesh)) {
        if (!mesh.solid(h)) continue;
        EXPECT_EQ(is_swap(mesh, h), is_swap(mesh, mesh.opposite(h)));
        swaps += is_swap(mesh, h) ? 1 : 0;
      }
      EXPECT_EQ(swaps, 2 * cost_of(mesh).swaps);
      all += swaps;
    }
  EXPECT_GT(all, 200);
}

}  // namespace
}  // namespace restrip
