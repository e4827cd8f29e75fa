// Moves of descents and of searches at strip ends, made and enumerated by their definition, and the cost of a
// colouring, counted along the listed strips by the vertices that they turn around. Independent of how the library
// finds and prices them.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <set>
#include <span>
#include <vector>

#include "restrip/mesh/cost.hpp"
#include "restrip/output/strips.hpp"
#include "sample_meshes.hpp"
#include "search/chain_search.hpp"

namespace restrip {

/// Strips, swaps and isolated triangles of a valid colouring.
inline ColoringChange cost_of(const StripMesh& mesh) {
  const Strips strips = extract_strips(mesh);
  EXPECT_EQ(strips.order.size(), mesh.triangle_count()) << "a solid cycle";
  ColoringChange cost;
  cost.strips = static_cast<int>(strips.size());
  for (std::size_t s = 0; s < strips.size(); ++s) {
    const auto strip = strips[s];
    cost.isolated += strip.size() == 1 ? 1 : 0;
    // The mesh edge between two triangles that follow each other, as two vertices.
    const auto edge_after = [&](std::size_t i) {
      for (unsigned side = 0; side < 3; ++side) {
        const StripMesh::Halfedge h = StripMesh::halfedge(strip[i], side);
        if (mesh.solid(h) && StripMesh::triangle(mesh.opposite(h)) == strip[i + 1])
          return std::array<Vertex, 2>{mesh.from(h), mesh.to(h)};
      }
      ADD_FAILURE() << "triangles that follow each other share no solid edge";
      return std::array<Vertex, 2>{};
    };
    // A strip goes through triangle i by two edges and turns around the vertex that they share.
    const auto pivot = [&](std::size_t i) {
      const auto in = edge_after(i - 1);
      const auto out = edge_after(i);
      return in[0] == out[0] || in[0] == out[1] ? in[0] : in[1];
    };
    for (std::size_t i = 1; i + 2 < strip.size(); ++i) cost.swaps += pivot(i) == pivot(i + 1) ? 1 : 0;
  }
  return cost;
}

inline ColoringChange operator-(const ColoringChange& a, const ColoringChange& b) {
  return {a.strips - b.strips, a.swaps - b.swaps, a.isolated - b.isolated};
}

}  // namespace restrip

namespace restrip::moves {

using Halfedge = StripMesh::Halfedge;
using sample::dual_edges;

inline constexpr std::int32_t any_price = 1'000'000;

inline const std::array<Cost, 4> some_costs{Cost::indices(), Cost::strips(), Cost{3, 1, 2}, Cost{2, 3, 0}};

// A dual edge as a number, the same from both sides.
inline std::uint32_t edge_number(const StripMesh& mesh, Halfedge h) { return std::min(h.id, mesh.opposite(h).id); }

// A move as the set of dual edges whose colours it changes.
using Changes = std::set<std::uint32_t>;

inline Changes changes_of(const StripMesh& mesh, const ChainMove& move) {
  Changes changes;
  if (!move.only_cuts()) changes.insert(edge_number(mesh, move.edge));
  if (!move.joins()) changes.insert(edge_number(mesh, move.cut));
  return changes;
}

/// Of those that cost `highest` at most.
inline std::multiset<Changes> changes_of(const StripMesh& mesh, std::span<const ChainMove> moves,
                                         std::int32_t highest = any_price) {
  std::multiset<Changes> all;
  for (const ChainMove& move : moves)
    if (move.price <= highest) all.insert(changes_of(mesh, move));
  return all;
}

inline void recolor(StripMesh& mesh, const Changes& changes) {
  std::vector<std::uint32_t> to_set;
  for (const std::uint32_t id : changes) {
    if (!mesh.solid({id})) to_set.push_back(id);
    if (mesh.solid({id})) mesh.set_solid({id}, false);
  }
  for (const std::uint32_t id : to_set) mesh.set_solid({id}, true);
}

// All moves at a strip end over the side h, from the definition in chain_search.cpp: h becomes solid, and a triangle
// across that has two solid edges gives up one of them. Pairs of triangles that follow each other already have none,
// nor have three triangles around one vertex, which follow each other but for the ends.
inline std::vector<Changes> moves_over(const StripMesh& mesh, Halfedge h) {
  const Triangle end = StripMesh::triangle(h);
  const Triangle across = StripMesh::triangle(mesh.opposite(h));
  const std::uint32_t edge = edge_number(mesh, h);
  const auto solid_edges = [&](Triangle triangle) {
    std::vector<Halfedge> edges;
    for (unsigned side = 0; side < 3; ++side)
      if (mesh.solid(StripMesh::halfedge(triangle, side))) edges.push_back(StripMesh::halfedge(triangle, side));
    return edges;
  };
  Triangle last = none;
  for (const Halfedge g : solid_edges(end)) last = StripMesh::triangle(mesh.opposite(g));
  if (last == across) return {};
  const std::vector<Halfedge> edges = solid_edges(across);
  if (edges.size() < 2) return {{edge}};
  std::vector<Changes> moves;
  for (const Halfedge g : edges)
    if (StripMesh::triangle(mesh.opposite(g)) != last || last == none) moves.push_back({edge, edge_number(mesh, g)});
  return moves;
}

// All moves that begin at a strip end.
inline std::multiset<Changes> moves_from(const StripMesh& mesh, Triangle end) {
  std::multiset<Changes> all;
  for (unsigned side = 0; side < 3; ++side) {
    const Halfedge h = StripMesh::halfedge(end, side);
    const Halfedge back = mesh.opposite(h);
    if (mesh.solid(h) || StripMesh::on_boundary(back) || StripMesh::triangle(back) == end) continue;
    for (const Changes& move : moves_over(mesh, h)) all.insert(move);
  }
  return all;
}

// The least price of a valid move, by counting.
inline std::int32_t best_price(const StripMesh& mesh, const Cost& cost, const std::multiset<Changes>& moves) {
  const std::int32_t before = cost_of(mesh).price(cost);
  std::int32_t best = any_price;
  for (const Changes& move : moves) {
    StripMesh after = mesh;
    recolor(after, move);
    if (check_coloring(after).valid) best = std::min(best, cost_of(after).price(cost) - before);
  }
  return best;
}

// Compares the moves that a search finds at a triangle, and their prices; calls valid(move, whether it is). Returns how
// many prices were compared.
template <class Search, class Valid>
std::size_t expect_moves_right(const StripMesh& mesh, Search& search, Triangle t,
                               const std::multiset<Changes>& expected, Valid&& valid) {
  const ColoringChange before = cost_of(mesh);
  const auto found = search.moves_at(mesh, t, any_price);
  const std::vector<ChainMove> all(found.begin(), found.end());
  EXPECT_EQ(changes_of(mesh, all), expected) << "triangle " << t;
  std::size_t compared = 0;
  for (const ChainMove& move : all) {
    StripMesh after = mesh;
    recolor(after, changes_of(mesh, move));
    const bool is_valid = check_coloring(after).valid;
    valid(move, is_valid);
    if (!is_valid) continue;
    EXPECT_EQ(move.change, cost_of(after) - before);
    EXPECT_EQ(move.price, move.change.price(search.cost()));
    ++compared;
  }
  return compared;
}

// A limit on the price leaves out moves and nothing else.
template <class Search>
void expect_limits_right(const StripMesh& mesh, Search& search, Triangle t) {
  const auto found = search.moves_at(mesh, t, any_price);
  const std::vector<ChainMove> all(found.begin(), found.end());
  for (std::int32_t highest = -8; highest <= 4; ++highest)
    EXPECT_EQ(changes_of(mesh, search.moves_at(mesh, t, highest)), changes_of(mesh, all, highest))
        << "triangle " << t << ", at most " << highest;
}

inline std::vector<Triangle> all_triangles(const StripMesh& mesh) {
  std::vector<Triangle> all;
  for (Triangle t = 0; t < mesh.triangle_bound(); ++t)
    if (mesh.alive(t)) all.push_back(t);
  return all;
}

// Repeats run() until it lowers the cost no more. Colours stay valid, changes are reported, and in the end none of the
// moves at strip ends lowers the cost.
template <class Run>
void expect_ends_where_no_move_pays(StripMesh& mesh, const Cost& cost, Run&& run) {
  const ColoringChange before = cost_of(mesh);
  ColoringChange sum;
  for (ColoringChange reported{-1, -1, -1}; reported.price(cost) < 0;) {
    reported = run();
    ASSERT_TRUE(check_coloring(mesh).valid);
    sum += reported;
    EXPECT_EQ(sum, cost_of(mesh) - before);
    EXPECT_LE(reported.price(cost), 0);
  }
  std::multiset<Changes> all;
  for (const Triangle t : all_triangles(mesh))
    if (mesh.solid_degree(t) < 2) all.merge(moves_from(mesh, t));
  EXPECT_GE(best_price(mesh, cost, all), 0);
}

// Calls visit(mesh, cost) for every valid colouring of every sample mesh of fewer than eight triangles, and of some
// more; one of some_costs with each.
template <class Visit>
void for_each_small_coloring(Visit&& visit) {
  std::vector<StripMesh> small{sample::octahedron(), sample::double_cone(3), sample::double_cone(2),
                               sample::rectangle(2, 2)};
  for (const StripMesh& mesh : sample::meshes())
    if (mesh.triangle_count() < 8) small.push_back(mesh);
  for (StripMesh& mesh : small) {
    const std::vector<Halfedge> edges = dual_edges(mesh);
    ASSERT_LE(edges.size(), 12U);
    for (std::uint32_t colors = 0; colors < 1U << edges.size(); ++colors) {
      for (std::size_t i = 0; i < edges.size(); ++i) mesh.set_solid(edges[i], (colors >> i & 1U) != 0);
      if (check_coloring(mesh).valid) visit(mesh, some_costs[colors % some_costs.size()]);
      if (testing::Test::HasFailure()) return;
    }
  }
}

}  // namespace restrip::moves
