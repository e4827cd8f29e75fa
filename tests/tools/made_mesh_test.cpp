// Claims: a made mesh is a closed oriented manifold of genus 1 with irregular valences, of about the requested size,
// and the same on every machine.
#include "meshes/made_mesh.hpp"

#include <gtest/gtest.h>

#include <bit>

#include "meshes/mesh_report.hpp"
#include "meshes/soup.hpp"

namespace restrip::tools {
namespace {

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
