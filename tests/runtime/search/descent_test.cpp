// Every move of a descent has the stated price, its list of moves is complete, a move is refused exactly when it would
// close a cycle, and a descent ends in a colouring that no move improves. All by the definitions: moves are enumerated,
// made on a copy of the mesh, and the copy is counted as a whole.
#include "restrip/search/impl/descent.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>
#include <vector>

#include "coloring_cost.hpp"
#include "restrip/search/stripify.hpp"
#include "sample_meshes.hpp"
#include "strip_moves.hpp"

namespace restrip {
namespace {

using namespace moves;

// Compares everything at every triangle; returns how many moves were compared.
std::size_t expect_all_moves_right(const StripMesh& mesh, Descent& descent) {
  std::size_t compared = 0;
  for (const Triangle t : all_triangles(mesh))
    compared += expect_moves_right(
        mesh, descent, t, moves_around(mesh, t, true),
        [&](const StripMove& move, bool valid) { EXPECT_EQ(descent.keeps_strips(mesh, move), valid); });
  return compared;
}

TEST(Moves, AreCompleteAndPricedAsCountedInEveryColoringOfSmallMeshes) {
  std::size_t compared = 0;
  for_each_small_coloring([&](const StripMesh& mesh, const Cost& cost) {
    Descent descent(cost);
    compared += expect_all_moves_right(mesh, descent);
  });
  EXPECT_GT(compared, 10'000U);
}

TEST(Moves, ArePricedAsCountedInRandomColorings) {
  std::mt19937 random(7);
  for (StripMesh& mesh : sample::meshes()) {
    for (const double share : {0.3, 0.7, 1.0}) {
      sample::color_at_random(mesh, share, random);
      for (const Cost& cost : some_costs) {
        Descent descent(cost);
        for (const Triangle t : all_triangles(mesh)) expect_limits_right(mesh, descent, t);
      }
      Descent descent;
      EXPECT_GT(expect_all_moves_right(mesh, descent), 0U);
      if (HasFailure()) return;
    }
  }
}

// One call continues from the triangles that it touches; what moves make possible further away, the next call finds.
TEST(Descent, RepeatedEndsWhereNoMoveImproves) {
  std::mt19937 random(11);
  for (StripMesh& mesh : sample::meshes())
    for (const Cost& cost : some_costs)
      for (const std::uint32_t tries : {0U, 3U}) {
        sample::color_at_random(mesh, 0.6, random);
        Descent descent(cost);
        const auto run = [&] { return descent.run(mesh, all_triangles(mesh), {.tries = tries, .worse = 1}); };
        expect_ends_where_no_move_pays(mesh, cost, run, all_triangles, true);
      }
}

// Chains end lower, all taken together, and each descent of single moves can be gone on with by chains.
TEST(Descent, ChainsFindWhatSingleMovesDoNot) {
  std::mt19937 random(13);
  int gained = 0;
  for (StripMesh& mesh : sample::meshes()) {
    for (const Cost& cost : {Cost::indices(), Cost::strips()}) {
      sample::color_at_random(mesh, 0.5, random);
      Descent descent(cost);
      descent.run(mesh, all_triangles(mesh));
      const ColoringChange before = cost_of(mesh);
      const ColoringChange reported = descent.run(mesh, all_triangles(mesh), {.tries = 4, .worse = 1});
      EXPECT_EQ(reported, cost_of(mesh) - before);
      EXPECT_LE(reported.price(cost), 0);
      gained -= reported.price(cost);
    }
  }
  EXPECT_GT(gained, 20);
}

TEST(Descent, KeepsToItsLimits) {
  constexpr std::uint64_t most_of_a_look = 5 * 18;  // a chain looks at four more triangles, once for each of its tries
  for (const std::uint32_t tries : {0U, 3U}) {
    for (const std::uint32_t moves : {0U, 1U, 10U, 100U}) {
      StripMesh mesh = sample::torus(20, 15);
      stripify_fast(mesh);
      Descent descent;
      descent.run(mesh, all_triangles(mesh), {.moves = moves, .tries = tries, .worse = 1});
      EXPECT_LE(descent.counts().priced, moves + (moves == 0 ? 0 : most_of_a_look));
      EXPECT_GE(descent.counts().priced, moves);
    }
  }
}

// The dual edges around a tube that is one ring of triangles.
std::vector<Halfedge> ring_of(const StripMesh& mesh) {
  std::vector<Halfedge> ring;
  Halfedge in{none};
  for (Triangle t = 0; ring.size() < mesh.triangle_count(); t = StripMesh::triangle(in)) {
    unsigned side = 0;
    while (StripMesh::on_boundary(mesh.opposite(StripMesh::halfedge(t, side))) || StripMesh::halfedge(t, side) == in)
      ++side;
    ring.push_back(StripMesh::halfedge(t, side));
    in = mesh.opposite(ring.back());
  }
  return ring;
}

// Two strips make a ring: joining their ends is allowed where the walk along the shorter one ends.
TEST(Descent, RefusesWhatItCannotSee) {
  const auto keeps_strips = [](Vertex quadrilaterals, std::size_t shorter) {
    StripMesh mesh = sample::tube(quadrilaterals, 1);
    const std::vector<Halfedge> ring = ring_of(mesh);
    for (std::size_t i = 0; i < ring.size(); ++i)
      if (i != 0 && i != shorter) mesh.set_solid(ring[i], true);
    Descent descent;
    const bool keeps = descent.keeps_strips(mesh, {ring[0]});
    EXPECT_LE(descent.counts().walked, 2 * std::uint64_t{Descent::max_walk});
    return keeps;
  };
  EXPECT_TRUE(keeps_strips(100, 100));
  EXPECT_FALSE(keeps_strips(100, 0));  // one strip
  EXPECT_TRUE(keeps_strips(10'000, 10));
  EXPECT_TRUE(keeps_strips(10'000, Descent::max_walk + 1));
  EXPECT_FALSE(keeps_strips(10'000, Descent::max_walk + 2));
  EXPECT_FALSE(keeps_strips(10'000, 0));
}

}  // namespace
}  // namespace restrip
