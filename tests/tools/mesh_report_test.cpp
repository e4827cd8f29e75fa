// Claims: the counts follow the definitions on meshes small enough to count by hand; each kind of fault is
// found. That they equal the paper's tables on its meshes: paper_test.cpp.
#include "meshes/mesh_report.hpp"

#include <gtest/gtest.h>

#include <bit>

#include "meshes/made_mesh.hpp"
#include "meshes/soup.hpp"
#include "shapes.hpp"

namespace restrip::tools {
namespace {

TEST(MeshReport, Tetrahedron) {
  const MeshReport r = report_on(tetrahedron());
  EXPECT_EQ(r.edges, 6U);
  EXPECT_EQ(r.boundary_edges, 0U);
  EXPECT_EQ(r.components, 1U);
  EXPECT_EQ(r.euler_characteristic, 2);
  EXPECT_EQ(r.genus, 0);
  EXPECT_EQ(r.triangles_per_vertex, (std::vector<std::size_t>{0, 0, 0, 4}));
}

TEST(MeshReport, SheetWithBoundary) {
  Soup soup = sheet(3);
  soup.points.push_back({9, 9, 9});
  const MeshReport r = report_on(soup);
  EXPECT_EQ(r.vertices, 17U);
  EXPECT_EQ(r.used_vertices, 16U);
  EXPECT_EQ(r.boundary_edges, 12U);
  EXPECT_EQ(r.boundary_loops, 1U);
  EXPECT_EQ(r.euler_characteristic, 1);
  EXPECT_EQ(r.genus, 0);
}

TEST(MeshReport, BowTies) {
  const MeshReport r = report_on(bow_tie());
  EXPECT_EQ(r.bow_tie_vertices, 1U);
  EXPECT_EQ(r.components, 1U);
  EXPECT_FALSE(r.manifold());
  // Two triangles with one vertex in common: loops that touch there are two.
  const MeshReport touching = report_on({{{}, {}, {}, {}, {}}, {{0, 1, 2}, {0, 3, 4}}});
  EXPECT_EQ(touching.boundary_loops, 2U);
  EXPECT_EQ(touching.bow_tie_vertices, 1U);
}

TEST(MeshReport, Faults) {
  Soup soup = tetrahedron();
  soup.triangles.push_back({2, 1, 0});  // a duplicate, turned over
  soup.triangles.push_back({1, 1, 3});  // degenerate
  const MeshReport r = report_on(soup);
  EXPECT_EQ(r.duplicate_faces, 1U);
  EXPECT_EQ(r.degenerate_faces, 1U);
  EXPECT_EQ(r.non_manifold_edges, 3U);
  EXPECT_EQ(r.bow_tie_vertices, 0U);
  Soup turned = tetrahedron();
  std::swap(turned.triangles[0][0], turned.triangles[0][1]);
  EXPECT_EQ(report_on(turned).inconsistent_edges, 3U);
  EXPECT_FALSE(report_on(turned).manifold());
}

// ---- made meshes
/// FNV-1a over corners and coordinates.
std::uint64_t fingerprint(const Soup& soup) {
  std::uint64_t hash = 0xCBF29CE484222325U;
  const auto add = [&hash](std::uint32_t value) { hash = (hash ^ value) * 0x100000001B3U; };
  for (const Point& p : soup.points)
    for (const double x : {p.x, p.y, p.z}) add(std::bit_cast<std::uint32_t>(static_cast<float>(x)));
  for (const Corners& t : soup.triangles)
    for (const std::uint32_t corner : t) add(corner);
  return hash;
}

TEST(MadeMesh, IsAClosedTorusOfEverySize) {
  for (const std::size_t size : {std::size_t{32}, std::size_t{33}, std::size_t{100}, std::size_t{777},
                                 std::size_t{5000}, default_made_triangles}) {
    const MeshReport r = report_on(make_mesh(size));
    EXPECT_TRUE(r.manifold()) << size;
    EXPECT_EQ(r.genus, 1) << size;
    EXPECT_EQ(r.euler_characteristic, 0) << size;
    EXPECT_EQ(r.boundary_edges, 0U) << size;
    EXPECT_EQ(r.components, 1U) << size;
    EXPECT_NEAR(static_cast<double>(r.triangles), static_cast<double>(size), 8 + 0.1 * static_cast<double>(size));
  }
}

TEST(MadeMesh, ValencesAreIrregular) {
  const MeshReport r = report_on(make_mesh());
  ASSERT_EQ(r.triangles_per_vertex.size(), 11U);
  for (std::size_t n = 3; n <= 10; ++n) EXPECT_GT(r.triangles_per_vertex[n], 0U) << n;
  EXPECT_LT(r.triangles_per_vertex[6], r.vertices / 2);
}

TEST(MadeMesh, IsTheSameOnEveryMachine) {
  EXPECT_EQ(fingerprint(make_mesh(1000, 1)), 0xA68698D8FB314A17U);
  EXPECT_NE(fingerprint(make_mesh(1000, 2)), fingerprint(make_mesh(1000, 1)));
}

TEST(MadeMesh, SizesOutOfRangeAreRefused) {
  EXPECT_THROW((void)make_mesh(least_made_triangles - 1), BadInput);
  EXPECT_THROW((void)make_mesh(most_made_triangles + 1), BadInput);
}

}  // namespace
}  // namespace restrip::tools
