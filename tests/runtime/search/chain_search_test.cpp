// Every move at the end of a strip has the stated price, and no such move is missing; walks find every cycle; a search
// never raises the cost, reports its changes, keeps to its limits, ends when no move at an end lowers the cost, finds
// chains where no move helps, and does not report moves that it undoes. All by the definitions: moves are enumerated,
// made on a copy of the mesh, and the copy is counted as a whole.
#include "search/chain_search.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <optional>
#include <random>
#include <set>
#include <vector>

#include "sample_meshes.hpp"
#include "search/greedy.hpp"
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

// Compares everything at every end, also whether walks know which moves close a cycle; returns how many moves were
// compared.
std::size_t expect_end_moves_right(const StripMesh& mesh, ChainSearch& search) {
  std::size_t compared = 0;
  for (const Triangle end : all_ends(mesh)) {
    compared += expect_moves_right(mesh, search, end, moves_from(mesh, end), [&](const ChainMove& move, bool is_valid) {
      EXPECT_EQ(search.keeps_strips(mesh, move), is_valid);
    });
    expect_limits_right(mesh, search, end);
  }
  return compared;
}

TEST(ChainMoves, AreCompleteAndPricedAsCountedInEveryColoringOfSmallMeshes) {
  std::size_t compared = 0;
  for_each_small_coloring([&](const StripMesh& mesh, const Cost& cost) {
    ChainSearch search(cost);
    compared += expect_end_moves_right(mesh, search);
  });
  EXPECT_GT(compared, 10'000U);
}

// Every swap, and no other edge, can be cut.
TEST(ChainMoves, CutsArePricedAsCounted) {
  std::mt19937 random(32);
  std::array<std::size_t, 4> with_swaps{};
  for (StripMesh& mesh : sample::meshes()) {
    sample::color_at_random(mesh, 1.0, random);
    const ColoringChange before = cost_of(mesh);
    for (const Triangle t : all_triangles(mesh))
      for (unsigned side = 0; side < 3; ++side) {
        const Halfedge h = StripMesh::halfedge(t, side);
        if (!mesh.solid(h)) continue;
        const ChainSearch search({7, 3, 1});
        const std::optional<ChainMove> cut = search.cut_at(mesh, h);
        ASSERT_EQ(cut.has_value(), is_swap(mesh, h));
        if (!cut) continue;
        EXPECT_TRUE(cut->only_cuts());
        EXPECT_EQ(cut->end(), t);
        StripMesh after = mesh;
        after.set_solid(h, false);
        EXPECT_EQ(cut->change, cost_of(after) - before);
        EXPECT_EQ(cut->price, cut->change.price(search.cost()));
        ++with_swaps[static_cast<std::size_t>(-cut->change.swaps)];
      }
  }
  for (const std::size_t swaps : {1U, 2U, 3U}) EXPECT_GT(with_swaps[swaps], 10U) << swaps;
}

ColoringChange run_everywhere(StripMesh& mesh, ChainSearch& search, const ChainLimits& limits) {
  return search.run(mesh, all_triangles(mesh), limits);
}

TEST(ChainSearch, RepeatedEndsWhereNoMoveAtAnEndPays) {
  std::mt19937 random(33);
  for (StripMesh& mesh : sample::meshes())
    for (const Cost& cost : some_costs)
      for (const ChainLimits& limits : {ChainLimits{}, ChainLimits{.length = 3, .worse = 1}}) {
        sample::color_at_random(mesh, 0.6, random);
        ChainSearch search(cost);
        expect_ends_where_no_move_pays(mesh, cost, [&] { return run_everywhere(mesh, search, limits); });
      }
}

// A strip whose ends are far away is left by cuts at its swaps alone.
TEST(ChainSearch, CutsAStripAtItsSwaps) {
  StripMesh mesh = sample::torus(30, 30);
  stripify_fast(mesh);
  const std::size_t strips = count_strips(mesh);
  std::vector<Triangle> inside = all_triangles(mesh);
  for (const Triangle end : all_ends(mesh))
    std::erase_if(inside, [&](Triangle t) {
      const auto is_next = [&](unsigned side) {
        return StripMesh::triangle(mesh.opposite(StripMesh::halfedge(t, side))) == end;
      };
      return t == end || is_next(0) || is_next(1) || is_next(2);
    });
  const ColoringChange before = cost_of(mesh);
  ChainSearch search;
  const ColoringChange change = search.run(mesh, inside, {.looks = 2000, .length = 4, .worse = 2});
  EXPECT_TRUE(check_coloring(mesh).valid);
  EXPECT_EQ(change, cost_of(mesh) - before);
  EXPECT_LT(change.price(search.cost()), -10);
  EXPECT_GT(count_strips(mesh), strips);
}

TEST(ChainSearch, KeepsToItsLimits) {
  for (const std::uint32_t length : {1U, 3U, 8U})
    for (const std::uint32_t looks : {0U, 1U, 7U, 50U}) {
      StripMesh mesh = sample::torus(20, 15);
      stripify_fast(mesh);
      ChainSearch search;
      for (const Triangle t : all_triangles(mesh)) {
        const std::uint64_t before = search.counts().looked;
        search.run(mesh, std::array{t, t}, {.looks = looks, .length = length, .worse = 2});
        EXPECT_LE(search.counts().looked - before, looks);
      }
      EXPECT_EQ(search.counts().looked > 0, looks > 0);
    }
}

// Moves that are tried and taken back are not reported, those that are made are.
TEST(ChainSearch, ReportsMovesToWatchers) {
  StripMesh mesh = sample::torus(20, 15);
  stripify_fast(mesh);
  std::vector<Triangle> changed;
  mesh.watch(&changed);
  ChainSearch search;
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

// The cheapest colouring that chains reach, by trying all of them on copies: each move valid, no end twice, no
// colouring on the way above `worse`.
std::int32_t cheapest_chain(const StripMesh& mesh, const Cost& cost, Triangle end, std::set<Triangle>& ends,
                            std::int32_t price, std::uint32_t length, std::int32_t worse) {
  std::int32_t best = 0;
  ChainSearch search(cost);
  const auto found = search.moves_at(mesh, end, any_price);
  for (const ChainMove& move : std::vector<ChainMove>(found.begin(), found.end())) {
    StripMesh after = mesh;
    recolor(after, changes_of(mesh, move));
    const std::int32_t now = price + move.price;
    if (!check_coloring(after).valid) continue;
    best = std::min(best, now);
    if (move.joins() || length == 1 || now > worse || !ends.insert(move.end()).second) continue;
    best = std::min(best, cheapest_chain(after, cost, move.end(), ends, now, length - 1, worse));
    ends.erase(move.end());
  }
  return best;
}

// It finds a chain that gains only where the enumeration has one, and misses few: those through a triangle that another
// chain ends in.
TEST(ChainSearch, FindsChainsThatAnEnumerationFinds) {
  std::size_t gainful = 0;
  std::size_t missed = 0;
  std::size_t tried = 0;
  for_each_small_coloring([&](const StripMesh& mesh, const Cost& cost) {
    if (++tried % 20 != 0) return;
    for (const Triangle end : all_ends(mesh)) {
      StripMesh changed = mesh;
      ChainSearch search(cost);
      search.run(changed, std::array{end}, {.length = 3, .worse = 2});
      const std::int32_t gained = cost_of(changed).price(cost) - cost_of(mesh).price(cost);
      std::set<Triangle> ends{end};
      const std::int32_t best = cheapest_chain(mesh, cost, end, ends, 0, 3, 2);
      if (gained < 0) {
        EXPECT_LT(best, 0);
      }
      gainful += best < 0 ? 1U : 0U;
      missed += best < 0 && gained == 0 ? 1U : 0U;
    }
  });
  EXPECT_GT(gainful, 300U);
  EXPECT_LT(20 * missed, gainful);
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
TEST(ChainSearch, RefusesWhatItCannotSee) {
  const auto keeps_strips = [](Vertex quadrilaterals, std::size_t shorter) {
    StripMesh mesh = sample::tube(quadrilaterals, 1);
    const std::vector<Halfedge> ring = ring_of(mesh);
    for (std::size_t i = 0; i < ring.size(); ++i)
      if (i != 0 && i != shorter) mesh.set_solid(ring[i], true);
    ChainSearch search;
    const bool keeps = search.keeps_strips(mesh, {ring[0], {}, {}, 0});
    EXPECT_LE(search.counts().walked, 2 * std::uint64_t{ChainSearch::max_walk});
    return keeps;
  };
  EXPECT_TRUE(keeps_strips(100, 100));
  EXPECT_FALSE(keeps_strips(100, 0));  // one strip
  EXPECT_TRUE(keeps_strips(10'000, 10));
  EXPECT_TRUE(keeps_strips(10'000, ChainSearch::max_walk + 1));
  EXPECT_FALSE(keeps_strips(10'000, ChainSearch::max_walk + 2));
  EXPECT_FALSE(keeps_strips(10'000, 0));
}

}  // namespace
}  // namespace restrip
