// Under Policy::local no dashed edge ever joins ends of two different strips; and wherever none does, the bounds of
// docs/explanation/theory.md, "What holds for the whole mesh", hold. All of it is counted by extracting all strips.
#include "operations/join.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "random_operation.hpp"
#include "restrip/mesh/walks.hpp"
#include "restrip/output/strips.hpp"
#include "restrip/search/keeper.hpp"
#include "restrip/search/stripify.hpp"
#include "sample_meshes.hpp"
#include "whole_mesh.hpp"

namespace restrip {
namespace {

using Halfedge = StripMesh::Halfedge;

struct Ends {
  std::size_t strips = 0;
  std::size_t isolated = 0;
  std::size_t meeting = 0;         ///< dashed edges between ends of different strips
  std::size_t own = 0;             ///< dashed edges between the two ends of one strip
  std::size_t boundary_sides = 0;  ///< of strip ends and isolated triangles
};

Ends count_ends(const StripMesh& mesh) {
  const Strips strips = extract_strips(mesh);
  std::vector<std::size_t> strip_of(mesh.triangle_bound(), 0);
  Ends count{strips.size()};
  for (std::size_t s = 0; s < strips.size(); ++s) {
    count.isolated += strips[s].size() == 1 ? 1U : 0U;
    for (const Triangle t : strips[s]) strip_of[t] = s;
  }
  for (const Halfedge h : sample::sides_of(mesh)) {
    const Triangle t = StripMesh::triangle(h);
    if (mesh.solid_degree(t) > 1) continue;
    const Halfedge across = mesh.opposite(h);
    if (StripMesh::on_boundary(across)) {
      ++count.boundary_sides;
      continue;
    }
    const Triangle u = StripMesh::triangle(across);
    if (mesh.solid(h) || mesh.solid_degree(u) > 1 || u < t) continue;
    ++(strip_of[t] == strip_of[u] ? count.own : count.meeting);
  }
  return count;
}

void expect_bound(const StripMesh& mesh) {
  const Ends ends = count_ends(mesh);
  ASSERT_EQ(ends.meeting, 0U);
  ASSERT_LE(6 * ends.strips, mesh.triangle_count() + 2 * ends.isolated + 2 * ends.own + ends.boundary_sides);
  ASSERT_LE(ends.isolated + ends.own, ends.strips);  // with it the first bound gives the second
}

std::vector<StripMesh> meshes() {
  return {sample::octahedron(), sample::torus(5, 4), sample::sphere(2),     sample::rectangle(5, 4),
          sample::tube(6, 2),   sample::torus(9, 9), sample::double_cone(9)};
}

unsigned side(std::mt19937& random) { return static_cast<unsigned>(random() % 3); }

TEST(Join, FindsWhetherTwoEndsAreOfOneStrip) {
  std::mt19937 random(1);
  std::size_t same = 0;
  std::size_t different = 0;
  for (StripMesh mesh : meshes())
    for (int round = 0; round < 30; ++round) {
      stripify(mesh, Effort::fast, Cost::strips());
      for (Triangle t = 0; t < mesh.triangle_bound(); ++t)
        if (const Halfedge h = StripMesh::halfedge(t, side(random)); mesh.solid(h) && random() % 4 == 0)
          mesh.set_solid(h, false);
      const Strips strips = extract_strips(mesh);
      for (std::size_t s = 0; s < strips.size(); ++s)
        for (std::size_t u = 0; u < strips.size(); ++u) {
          const Halfedge one = StripMesh::halfedge(strips[s].front(), side(random));
          const Halfedge other = StripMesh::halfedge(strips[u].back(), side(random));
          ASSERT_EQ(detail::same_strip(mesh, one, other), s == u);
          ++(s == u ? same : different);
        }
    }
  EXPECT_GT(same, 500U);
  EXPECT_GT(different, 5000U);
}

TEST(Join, AllLeavesNoEndsThatMeet) {
  for (StripMesh mesh : meshes()) {
    Census expected = census_of(mesh);  // all isolated
    expected += join_all(mesh);
    ASSERT_EQ(census_of(mesh), expected);
    expect_bound(mesh);
  }
}

TEST(Join, NoEndsMeetAfterAnyOperation) {
  for (const unsigned seed : {1U, 2U, 3U})
    for (StripMesh mesh : meshes()) {
      std::mt19937 random(seed);
      if (seed == 1) stripify(mesh, Effort::full, Cost::strips());  // few strips, whose own ends often meet
      join_all(mesh);
      Keeper keeper(mesh, Policy::local, Cost::strips());
      int done = 0;
      for (int n = 0; n < 1500 && done < 600; ++n) {
        done += random_operation(keeper, random, n / 100 % 2 == 0, all_operations) ? 1 : 0;
        expect_bound(mesh);
        if (HasFatalFailure()) FAIL() << "seed " << seed << ", attempt " << n;
      }
      EXPECT_GT(done, 100);
    }
}

// A closed strip around a tube of one ring, opened at one edge: its own ends meet. Whatever a flip cuts, its far ends
// do not stay apart, however far away they are.
TEST(Join, FarEndsThatACutPartsAreJoined) {
  const Vertex n = 40;
  std::vector<sample::Corners> ring;
  for (Vertex i = 0; i < n; ++i) {
    const Vertex next = (i + 1) % n;
    ring.push_back({2 * i, 2 * next, 2 * i + 1});
    ring.push_back({2 * i + 1, 2 * next, 2 * next + 1});
  }
  std::size_t flips = 0;
  for (Vertex seam = 0; seam < n; seam += 7) {
    StripMesh mesh = StripMesh::build(ring, std::size_t{2} * n);
    for (Vertex i = 0; i < n; ++i) {
      mesh.set_solid(mesh.spoke(2 * ((i + 1) % n), 2 * i + 1), true);
      mesh.set_solid(mesh.spoke(2 * i, 2 * i + 1), i != seam);
    }
    ASSERT_EQ(count_ends(mesh).own, 1U);
    ASSERT_EQ(count_strips(mesh), 1U);
    for (Triangle t = 0; t < 2 * n; ++t)
      for (unsigned side = 0; side < 3; ++side) {
        StripMesh copy = mesh;
        if (check_flip(copy, StripMesh::halfedge(t, side)) != Refusal::granted) continue;
        Keeper(copy, Policy::local, Cost::strips()).flip(StripMesh::halfedge(t, side));
        expect_bound(copy);
        ++flips;
      }
  }
  EXPECT_GT(flips, 500U);
}

// More strip ends around one vertex than join_ends() remembers.
TEST(Join, ManyEndsAroundOneVertex) {
  for (const Vertex k : {15U, 16U, 17U, 40U}) {
    StripMesh mesh = sample::double_cone(k);
    // Each strip is a pair of triangles, one at each apex, except for a few longer ones.
    for (Vertex i = 0; i < k; ++i) mesh.set_solid(mesh.spoke(2 + i, 2 + (i + 1) % k), true);
    ASSERT_EQ(count_strips(mesh), k);
    Census expected = census_of(mesh);
    std::vector<Halfedge> spokes = sample::spokes_around(mesh, 0);
    expected += detail::join_in(mesh, spokes);
    EXPECT_EQ(census_of(mesh), expected);
    EXPECT_LE(count_strips(mesh), k / 2);
    expect_bound(mesh);
  }
}

// All triangles are isolated, and each finds an isolated neighbour. So no triangle around the vertex stays isolated,
// whichever spoke it begins at.
TEST(Join, GoesAroundTheWholeFan) {
  for (const StripMesh& mesh : {sample::rectangle(4, 3), sample::tube(5, 2), sample::octahedron()})
    for (Vertex v = 0; v < mesh.vertex_bound(); ++v) {
      const std::vector<Halfedge> spokes = sample::spokes_around(mesh, v);
      for (std::size_t first = 0; first < spokes.size(); ++first) {
        StripMesh copy = mesh;
        Census expected = census_of(mesh);
        std::vector<Halfedge> around = spokes;
        std::rotate(around.begin(), around.begin() + static_cast<std::ptrdiff_t>(first), around.end());
        expected += detail::join_in(copy, around);
        EXPECT_EQ(census_of(copy), expected);
        for (const Halfedge h : spokes)
          EXPECT_TRUE(StripMesh::on_boundary(h) || copy.solid_degree(StripMesh::triangle(h)) > 0) << "vertex " << v;
      }
    }
}

}  // namespace
}  // namespace restrip
