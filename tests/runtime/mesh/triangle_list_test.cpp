// The neighbours in a triangle list are the ones of a table of all edges, for any list, and do not depend on the
// numbers of vertices; the report says what is wrong with it.
#include "restrip/mesh/triangle_list.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <random>
#include <stdexcept>
#include <utility>
#include <vector>

#include "restrip/mesh/strip_mesh.hpp"
#include "sample_meshes.hpp"

namespace restrip {
namespace {

using sample::Corners;
using Across = std::vector<std::array<std::uint32_t, 3>>;

struct Expected {
  Across across;
  BuildReport report;
  std::vector<std::vector<std::uint32_t>> odd = {};  // the sides of edges of more than two
};

// Every edge with all its sides.
Expected from_table(const std::vector<Corners>& list, std::size_t vertices) {
  Expected expected;
  expected.across.assign(list.size(), {none, none, none});
  std::map<std::pair<Vertex, Vertex>, std::vector<std::uint32_t>> edges;
  for (Triangle t = 0; t < list.size(); ++t) {
    const Corners& c = list[t];
    if (*std::max_element(c.begin(), c.end()) >= vertices)
      ++expected.report.out_of_range_triangles;
    else if (c[0] == c[1] || c[1] == c[2] || c[2] == c[0])
      ++expected.report.degenerate_triangles;
    else
      for (unsigned s = 0; s < 3; ++s) edges[std::minmax(c[s], c[(s + 1) % 3])].push_back(4 * t + s);
  }
  for (const auto& entry : edges) {
    const std::vector<std::uint32_t>& sides = entry.second;
    const auto from = [&](std::size_t i) { return list[sides[i] / 4][sides[i] % 4]; };
    if (sides.size() == 1) {
      ++expected.report.boundary_edges;
    } else if (sides.size() > 2) {
      ++expected.report.non_manifold_edges;
      expected.odd.push_back(sides);
    } else if (from(0) == from(1)) {
      ++expected.report.inconsistent_edges;
    } else {
      expected.across[sides[0] / 4][sides[0] % 4] = sides[1];
      expected.across[sides[1] / 4][sides[1] % 4] = sides[0];
    }
  }
  return expected;
}

// At an edge with more than two sides, the most possible pairs of sides with opposite directions.
void expect_pairs(const std::vector<Corners>& list, const std::vector<std::uint32_t>& sides, Across& across) {
  const auto from = [&](std::uint32_t h) { return list[h / 4][h % 4]; };
  const auto upwards = static_cast<std::size_t>(std::count_if(
      sides.begin(), sides.end(), [&](std::uint32_t h) { return from(h) < list[h / 4][(h % 4 + 1) % 3]; }));
  std::size_t joined = 0;
  for (const std::uint32_t h : sides) {
    const std::uint32_t there = across[h / 4][h % 4];
    if (there == none) continue;
    ++joined;
    ASSERT_TRUE(std::find(sides.begin(), sides.end(), there) != sides.end());
    ASSERT_EQ(across[there / 4][there % 4], h);
    ASSERT_NE(from(h), from(there));
  }
  ASSERT_EQ(joined, 2 * std::min(upwards, sides.size() - upwards));
  for (const std::uint32_t h : sides) across[h / 4][h % 4] = none;
}

void expect_table(const std::vector<Corners>& list, std::size_t vertices) {
  const Expected expected = from_table(list, vertices);
  Across across(list.size());
  BuildReport report;
  report.boundary_edges = 77;
  find_neighbors(TriangleList(list), vertices, across, report);
  Across of_manifold_edges = across;
  for (const auto& sides : expected.odd) expect_pairs(list, sides, of_manifold_edges);
  ASSERT_EQ(of_manifold_edges, expected.across);
  const auto counts = [](const BuildReport& of) {
    return std::array{of.degenerate_triangles, of.out_of_range_triangles, of.boundary_edges, of.non_manifold_edges,
                      of.inconsistent_edges};
  };
  ASSERT_EQ(counts(report), counts(expected.report));
  // Other numbers of the vertices change nothing.
  std::vector<Vertex> number(vertices);
  std::iota(number.begin(), number.end(), Vertex{0});
  std::shuffle(number.begin(), number.end(), std::mt19937(static_cast<unsigned>(list.size())));
  std::vector<Corners> renumbered = list;
  for (Corners& corners : renumbered)
    for (Vertex& v : corners) v = v < vertices ? number[v] : v;
  Across across_renumbered(list.size());
  find_neighbors(TriangleList(renumbered), vertices, across_renumbered, report);
  ASSERT_EQ(across_renumbered, across);
  // The mesh that is built of it has the same neighbours, by its own handles.
  BuildReport of_mesh;
  std::vector<std::uint32_t> origin;
  const StripMesh mesh = StripMesh::build(list, vertices, &of_mesh, &origin);
  ASSERT_EQ(counts(of_mesh), counts(report));
  for (const StripMesh::Halfedge h : sample::sides_of(mesh)) {
    const StripMesh::Halfedge there = mesh.opposite(h);
    const std::uint32_t named =
        StripMesh::on_boundary(there) ? none : 4 * origin[StripMesh::triangle(there)] + StripMesh::side(there);
    ASSERT_EQ(named, across[origin[StripMesh::triangle(h)]][StripMesh::side(h)]);
  }
}

TEST(TriangleList, NeighborsAreRightInEverySoup) {
  std::mt19937 random(1);
  for (unsigned round = 0; round < 4000; ++round) {
    const std::size_t vertices = 3 + round % 7;
    std::vector<Corners> list(random() % 12);
    // Some soups have corners twice and corners out of range, others do not.
    const auto corner = [&] { return static_cast<Vertex>(random() % (vertices + (round % 3 == 0 ? 1 : 0))); };
    for (Corners& c : list) do
        c = {corner(), corner(), corner()};
      while (round % 2 == 0 && (c[0] == c[1] || c[1] == c[2] || c[2] == c[0]));
    expect_table(list, vertices);
    if (HasFatalFailure()) return;
  }
}

TEST(TriangleList, NeighborsAreRightInMeshesInAnyOrder) {
  std::mt19937 random(2);
  for (const StripMesh& mesh : sample::meshes()) {
    std::vector<Corners> list = sample::triangles_of(mesh);
    std::shuffle(list.begin(), list.end(), random);
    expect_table(list, mesh.vertex_bound());
    if (HasFatalFailure()) return;
  }
}

TEST(TriangleList, ReadsTriplesAndIndicesOfTwoSizes) {
  const std::vector<Corners> triples{{0, 1, 2}, {2, 1, 3}, {3, 3, 0}, {1, 0, 9}};
  std::vector<std::uint32_t> wide;
  for (const Corners& c : triples) wide.insert(wide.end(), c.begin(), c.end());
  const std::vector<std::uint16_t> narrow(wide.begin(), wide.end());
  const auto expect_triples = [&](const auto& list) {
    ASSERT_EQ(list.size(), 4U);
    for (std::uint32_t side = 0; side < 16; ++side)
      if (side % 4 < 3) {
        EXPECT_EQ(list.corner(side), triples[side / 4][side % 4]);
      }
    EXPECT_TRUE(list.is_triangle(1, 4) && !list.is_triangle(1, 3));
    EXPECT_TRUE(list.degenerate(2) && !list.in_range(3, 4));
  };
  expect_triples(TriangleList(triples));
  expect_triples(TriangleList(wide));
  expect_triples(TriangleList(narrow));
  EXPECT_THROW((void)TriangleList(std::span(wide).first(8)), std::invalid_argument);
  Across across(4);
  BuildReport report;
  EXPECT_THROW(find_neighbors(TriangleList(wide), std::size_t{1} << 32, across, report), std::length_error);
}

}  // namespace
}  // namespace restrip
