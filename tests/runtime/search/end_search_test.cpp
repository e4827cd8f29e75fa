// Every move at the end of a strip has the stated price, and no such move is missing; a search never raises the cost,
// reports its changes, keeps to its limits, ends when no move at an end lowers the cost, and does not report moves that
// it undoes. All by the definitions: moves are enumerated, made on a copy of the mesh, and the copy is counted as a
// whole.
#include "restrip/search/impl/end_search.hpp"

#include <gtest/gtest.h>

#include <array>
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

std::vector<Triangle> all_ends(const StripMesh& mesh) {
  std::vector<Triangle> ends;
  for (const Triangle t : all_triangles(mesh))
    if (mesh.solid_degree(t) < 2) ends.push_back(t);
  return ends;
}

// Compares everything at every end; returns how many moves were compared.
std::size_t expect_end_moves_right(const StripMesh& mesh, EndSearch& search) {
  std::size_t compared = 0;
  for (const Triangle end : all_ends(mesh)) {
    compared += expect_moves_right(mesh, search, end, moves_around(mesh, end, false), [](const StripMove&, bool) {});
    expect_limits_right(mesh, search, end);
  }
  return compared;
}

TEST(EndMoves, AreCompleteAndPricedAsCountedInEveryColoringOfSmallMeshes) {
  std::size_t compared = 0;
  for_each_small_coloring([&](const StripMesh& mesh, const Cost& cost) {
    EndSearch search(cost);
    compared += expect_end_moves_right(mesh, search);
  });
  EXPECT_GT(compared, 10'000U);
}

TEST(EndMoves, ArePricedAsCountedInRandomColorings) {
  std::mt19937 random(31);
  std::size_t compared = 0;
  for (StripMesh& mesh : sample::meshes())
    for (const double share : {0.3, 0.7, 1.0}) {
      sample::color_at_random(mesh, share, random);
      for (const Cost& cost : some_costs) {
        EndSearch search(cost);
        compared += expect_end_moves_right(mesh, search);
        if (HasFailure()) return;
      }
    }
  EXPECT_GT(compared, 1000U);
}

// A call keeps 64 ends in mind, so it is given a few triangles at a time.
ColoringChange run_everywhere(StripMesh& mesh, EndSearch& search, const EndLimits& limits) {
  ColoringChange sum;
  const std::vector<Triangle> all = all_triangles(mesh);
  for (std::size_t i = 0; i < all.size(); i += 16)
    sum += search.run(mesh, std::span(all).subspan(i, std::min<std::size_t>(16, all.size() - i)), limits);
  return sum;
}

TEST(EndSearch, RepeatedEndsWhereNoMoveAtAnEndPays) {
  std::mt19937 random(33);
  for (StripMesh& mesh : sample::meshes())
    for (const Cost& cost : some_costs)
      for (const EndLimits& limits : {EndLimits{}, EndLimits{.looks = 300, .length = 3, .worse = 1}}) {
        sample::color_at_random(mesh, 0.6, random);
        EndSearch search(cost);
        expect_ends_where_no_move_pays(
            mesh, cost, [&] { return run_everywhere(mesh, search, limits); }, all_ends, false);
      }
}

TEST(EndSearch, LongerChainsEndLower) {
  std::int32_t last = 0;
  for (const std::uint32_t length : {1U, 2U, 4U}) {
    StripMesh mesh = sample::torus(30, 30);
    stripify_fast(mesh);
    EndSearch search;
    std::int32_t price = 0;
    for (int round = 0; round < 3; ++round)
      price += run_everywhere(mesh, search, {.looks = 1000, .length = length, .worse = 1}).price(search.cost());
    EXPECT_LT(price, last - 10) << length;
    last = price;
  }
}

TEST(EndSearch, KeepsToItsLimits) {
  for (const std::uint32_t length : {1U, 3U, 8U})
    for (const std::uint32_t looks : {0U, 1U, 7U, 50U}) {
      StripMesh mesh = sample::torus(20, 15);
      stripify_fast(mesh);
      EndSearch search;
      for (const Triangle t : all_triangles(mesh)) {
        const std::uint64_t before = search.counts().looked;
        search.run(mesh, std::array{t, t}, {.looks = looks, .length = length, .worse = 2});
        EXPECT_LE(search.counts().looked - before, looks);
      }
      EXPECT_EQ(search.counts().looked > 0, looks > 0);
      EXPECT_LE(search.counts().priced, 3 * search.counts().looked);
    }
}

// Moves that are tried and taken back are not reported, those that are made are.
TEST(EndSearch, ReportsMovesToWatchers) {
  StripMesh mesh = sample::torus(20, 15);
  stripify_fast(mesh);
  std::vector<Triangle> changed;
  mesh.watch(&changed);
  EndSearch search;
  std::size_t reported = 0;
  std::size_t quiet = 0;
  for (const Triangle t : all_triangles(mesh)) {
    const StripMesh before = mesh;
    const std::uint64_t made = search.counts().made;
    changed.clear();
    search.run(mesh, std::array{t}, {.looks = 100, .length = 4, .worse = 2});
    // Two triangles of each edge, one or two edges a move.
    EXPECT_LE(changed.size(), 4 * (search.counts().made - made));
    quiet += search.counts().made == made ? 1U : 0U;
    const std::set<Triangle> named(changed.begin(), changed.end());
    for (const Triangle u : all_triangles(mesh)) {
      if (mesh.solid_sides(u) == before.solid_sides(u)) continue;
      EXPECT_TRUE(named.contains(u));
      ++reported;
    }
  }
  EXPECT_GT(reported, 50U);
  EXPECT_GT(quiet, 50U);
}

}  // namespace
}  // namespace restrip
