// A StripMesh is built from triangles in any order, refuses more than it can hold before it reads them, and its list of
// changes names every triangle that changes. Undo and redo restore it exactly: triangles, handles, free handles and
// colours; for all operations and policies see live_random_test.cpp.
#include "restrip/mesh/strip_mesh.hpp"

#include <gtest/gtest.h>
#include <sys/mman.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <random>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

#include "mesh/history.hpp"
#include "random_operations.hpp"
#include "restrip/mesh/checks.hpp"
#include "sample_meshes.hpp"
#include "whole_mesh.hpp"

namespace restrip {
namespace {

// A corner twice, whichever two they are, and a corner that is not a vertex: left out and counted, and the others keep
// their order.
TEST(StripMesh, BuildCountsWhatItLeavesOut) {
  const std::vector<sample::Corners> triangles{{0, 0, 1}, {0, 1, 2}, {1, 2, 2}, {2, 1, 2},
                                               {0, 1, 4}, {1, 0, 3}, {3, 3, 3}};
  BuildReport report;
  std::vector<std::uint32_t> origin;
  const StripMesh mesh = StripMesh::build(triangles, 4, &report, &origin);
  EXPECT_EQ(report.degenerate_triangles, 4U);
  EXPECT_EQ(report.out_of_range_triangles, 1U);
  EXPECT_EQ(report.boundary_edges, 4U);
  EXPECT_EQ(report.non_manifold_edges + report.inconsistent_edges + report.non_manifold_vertices, 0U);
  EXPECT_EQ(origin, (std::vector<std::uint32_t>{1, 5}));
  ASSERT_EQ(mesh.triangle_count(), 2U);
  EXPECT_EQ(mesh.corners(0), triangles[1]);
  EXPECT_EQ(mesh.corners(1), triangles[5]);
}

// A range of addresses that may not be read: a look at a triangle before its count would end the program there.
TEST(StripMesh, MoreTrianglesThanItHoldsAreRefusedUnread) {
  const std::size_t count = StripMesh::max_triangles + 1;
  EXPECT_EQ(count, std::size_t{1} << 29);
  void* const range =
      mmap(nullptr, count * sizeof(sample::Corners), PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  ASSERT_NE(range, MAP_FAILED);
  const std::span<const sample::Corners> triangles(static_cast<const sample::Corners*>(range), count);
  EXPECT_THROW((void)StripMesh::build(triangles, 3), std::length_error);
  munmap(range, count * sizeof(sample::Corners));
  EXPECT_THROW((void)StripMesh::build({}, std::size_t{1} << 32), std::length_error);
}

// A watch moves only with its mesh; a copy has none.
TEST(StripMesh, AWatchMovesWithItsMesh) {
  const auto changes = [](StripMesh& mesh, const std::vector<Triangle>& list) {
    const std::size_t before = list.size();
    const StripMesh::Halfedge h = mesh.spoke(0);
    mesh.set_solid(h, !mesh.solid(h));
    return list.size() - before;
  };
  std::vector<Triangle> list;
  std::vector<Triangle> other_list;
  StripMesh mesh = sample::torus(4, 3);
  mesh.watch(&list);
  EXPECT_EQ(changes(mesh, list), 2U);

  StripMesh moved = std::move(mesh);
  EXPECT_EQ(changes(moved, list), 2U);
  mesh = sample::octahedron();  // no longer watched, and a new mesh is not either
  EXPECT_EQ(changes(mesh, list), 0U);

  moved = sample::octahedron();  // a mesh without a watch is assigned: moved keeps its own
  EXPECT_EQ(changes(moved, list), 2U);
  const StripMesh original = sample::octahedron();
  moved = original;
  EXPECT_EQ(changes(moved, list), 2U);

  mesh.watch(&other_list);
  std::swap(mesh, moved);
  EXPECT_EQ(changes(mesh, list), 2U);
  EXPECT_EQ(changes(moved, other_list), 2U);

  moved = std::move(mesh);  // two watches, one mesh: the one that comes along stays
  EXPECT_EQ(changes(moved, list), 2U);
  EXPECT_EQ(changes(moved, other_list), 0U);

  StripMesh copy = moved;
  EXPECT_EQ(changes(copy, list), 0U);
}

// Two triangles turned into two others are the same mesh as after a flip.
TEST(StripMesh, ReplacesTriangles) {
  StripMesh mesh = sample::torus(5, 5);
  const StripMesh::Halfedge h = StripMesh::halfedge(8, 2);
  const StripMesh::Halfedge back = mesh.opposite(h);
  const Vertex left = mesh.to(StripMesh::next(h));
  const Vertex right = mesh.to(StripMesh::next(back));
  const std::array<Triangle, 2> out{StripMesh::triangle(h), StripMesh::triangle(back)};
  const std::array<std::array<Vertex, 3>, 2> in{{{left, mesh.from(h), right}, {right, mesh.to(h), left}}};
  StripMesh turned = mesh;
  turned.turn_edge(h);
  std::array<Triangle, 2> made{};
  mesh.replace(out, in, made);
  EXPECT_EQ(sample::triangles_of(mesh), sample::triangles_of(turned));
  EXPECT_EQ(made, out);
  EXPECT_EQ(check_replace(mesh, out, in), Refusal::granted);  // the same again
}

// The room made in a watch's list suffices, also when triangles that fill a hole meet the same boundary vertices.
TEST(StripMesh, FillingAHoleNamesTrianglesAsOftenAsThereIsRoomFor) {
  for (Vertex n = 5; n <= 12; ++n) {
    std::vector<std::array<Vertex, 3>> ring;
    std::vector<std::array<Vertex, 3>> in;
    for (Vertex v = 0; v < n; ++v) {
      ring.push_back({v, (v + 1) % n, n + v});
      ring.push_back({(v + 1) % n, n + (v + 1) % n, n + v});
    }
    for (Vertex v = 2; v + 1 < n; ++v) in.push_back({1, v + 1, v});
    in.push_back({1, 0, n - 1});
    StripMesh mesh = StripMesh::build(ring, 2 * n);
    std::vector<Triangle> changed;
    mesh.watch(&changed);
    std::vector<Triangle> made(in.size());
    mesh.replace({}, in, made);
    // A new triangle is placed once, and each of its sides is joined once, with two names.
    EXPECT_LE(changed.size(), 7 * in.size()) << n;
    for (const Triangle t : made) EXPECT_EQ(std::count(changed.begin(), changed.end(), t), 4) << n;
  }
}

// First spokes differ then, or the free handles, although every triangle is as it was.
TEST(History, AFrameThatSplitsAndCollapsesBackIsAFrame) {
  std::mt19937 random(7);
  std::size_t triangles_as_they_were = 0;
  for (const StripMesh& start : {sample::octahedron(), sample::rectangle(4, 4), sample::torus(5, 5)})
    for (int round = 0; round < 400; ++round) {
      StripMesh mesh = start;
      std::vector<Triangle> changed;
      mesh.watch(&changed);
      History history(mesh);
      std::vector<Look> looks{look_at(mesh)};
      for (int frame = 0; frame < 6; ++frame) {
        const auto triangles = sample::triangles_of(mesh);
        if (random() % 3 == 0)
          checked_flip(mesh, random_halfedge(mesh, random));
        else if (const Checked up = checked_split(mesh, random_split(mesh, random_halfedge(mesh, random), random)))
          if (random() % 4 != 0)
            checked_collapse(mesh, random() % 2 == 0 ? up.rewrite.halfedge : mesh.opposite(up.rewrite.halfedge));
        const Look look = look_at(mesh);
        const bool kept = history.frame(mesh, changed);
        changed.clear();
        ASSERT_TRUE(kept || look == looks.back());
        if (!kept) continue;
        if (!(look == looks.back()) && sample::triangles_of(mesh) == triangles) ++triangles_as_they_were;
        looks.push_back(look);
      }
      for (int steps = 0; steps < 12; ++steps) {
        const bool back = random() % 3 != 0;
        if (back ? history.undo(mesh) : history.redo(mesh)) {
          ASSERT_EQ(fault_of(mesh), "");
          ASSERT_EQ(look_at(mesh), looks[history.undoable()]);
        }
      }
      mesh.watch(nullptr);
    }
  EXPECT_GT(triangles_as_they_were, 100U);
}

}  // namespace
}  // namespace restrip
