// A StripMesh is built from triangles in any order, refuses more than it can hold before it reads them, and its list of
// changes names every triangle that changes.
#include "restrip/mesh/strip_mesh.hpp"

#include <gtest/gtest.h>
#include <sys/mman.h>

#include <array>
#include <cstddef>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

#include "restrip/mesh/checks.hpp"
#include "sample_meshes.hpp"

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

// Two triangles turned into two others, and one into three, with the neighbours and the colours towards them as before.
TEST(StripMesh, ReplacesTrianglesAndKeepsTheColorsOfTheRim) {
  StripMesh mesh = sample::torus(5, 5);
  const StripMesh::Halfedge h = StripMesh::halfedge(8, 2);
  const StripMesh::Halfedge back = mesh.opposite(h);
  const std::array<StripMesh::Halfedge, 4> beyond{
      mesh.opposite(StripMesh::next(h)), mesh.opposite(StripMesh::next(StripMesh::next(h))),
      mesh.opposite(StripMesh::next(back)), mesh.opposite(StripMesh::next(StripMesh::next(back)))};
  mesh.set_solid(h, true);
  mesh.set_solid(beyond[0], true);
  mesh.set_solid(beyond[2], true);
  StripMesh turned = mesh;
  turned.turn_edge(h);
  const std::array<Triangle, 2> out{StripMesh::triangle(h), StripMesh::triangle(back)};
  const std::array<StripMesh::Places, 2> in{{{2, 0, 3}, {3, 1, 2}}};
  std::array<Vertex, 4> vertices{mesh.from(h), mesh.to(h), mesh.to(beyond[1]), mesh.to(beyond[3])};
  std::array<Triangle, 2> made{};
  ASSERT_EQ(check_replace(mesh, out, in, vertices), Refusal::granted);
  mesh.replace(out, in, vertices, made);
  EXPECT_EQ(sample::triangles_of(mesh), sample::triangles_of(turned));
  EXPECT_EQ(made, out);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(mesh.solid(beyond[i]), i % 2 == 0);
  EXPECT_FALSE(mesh.solid(mesh.spoke(vertices[2], vertices[3])));
  // A vertex that is not listed, one that is listed without need, two that are one, and a rim that is another.
  const auto refusal = [&](std::span<const Vertex> named, const StripMesh::Places& first) {
    const std::array<StripMesh::Places, 2> wanted{{first, {3, 1, 2}}};
    return check_replace(turned, out, wanted, named);
  };
  const std::array<Vertex, 5> more{vertices[0], vertices[1], vertices[2], vertices[3], 24};
  EXPECT_EQ(refusal(std::span(vertices).first(3), {2, 0, 3}), Refusal::other_patch);
  EXPECT_EQ(refusal(more, {2, 0, 3}), Refusal::other_patch);
  const std::array<Vertex, 5> twice{vertices[0], vertices[1], vertices[2], vertices[3], vertices[0]};
  EXPECT_EQ(refusal(twice, {2, 0, 3}), Refusal::same_vertex);
  EXPECT_EQ(refusal(vertices, {2, 1, 3}), Refusal::edge_exists);
  EXPECT_EQ(refusal(vertices, {3, 1, 2}), Refusal::other_patch);
  EXPECT_EQ(refusal(vertices, {2, 2, 3}), Refusal::other_patch);
  EXPECT_EQ(refusal(vertices, {2, 0, 3}), Refusal::granted);
}

}  // namespace
}  // namespace restrip
