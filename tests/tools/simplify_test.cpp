// Claims: simplification reaches its target or says why not, its splits lead back to exactly the triangles of the soup,
// and non-manifold parts are left unchanged and counted. tests/tools/simplifier_test.cpp judges the collapses.
#include "lod/simplify.hpp"

#include <gtest/gtest.h>

#include <utility>

#include "folders.hpp"
#include "lod/coloring_check.hpp"
#include "lod/mesh_files.hpp"
#include "meshes/made_mesh.hpp"
#include "restrip/mesh/checks.hpp"
#include "shapes.hpp"

namespace restrip::tools {
namespace {

/// Splits the base back up, checks each split, and compares.
void expect_leads_back(const ProgressiveMesh& progressive, const Soup& soup) {
  StripMesh mesh = StripMesh::build(progressive.base, progressive.points.size());
  for (const Record& record : progressive.splits) {
    const auto where = spokes_of(mesh, record);
    ASSERT_EQ(check_split(mesh, where), Refusal::granted);
    const auto chord = mesh.insert_vertex(where, record.v_t);
    ASSERT_EQ(mesh.from(chord), record.v_s);
    ASSERT_EQ(mesh.to(chord), record.v_t);
  }
  EXPECT_TRUE(find_faults(mesh).empty());
  EXPECT_EQ(sorted_triangles(corners_of(mesh)), sorted_triangles(soup.triangles));
}

TEST(Simplify, ClosedMeshReachesItsTarget) {
  const Soup soup = make_mesh(4000);
  const Simplification result = simplify(soup, {0.05, BoundaryPolicy::move});
  EXPECT_LE(result.mesh.base.size(), result.wanted_triangles);
  EXPECT_GT(result.mesh.base.size() + 2, result.wanted_triangles);
  EXPECT_EQ(result.mesh.fine_triangles(), soup.triangles.size());
  expect_leads_back(result.mesh, soup);
}

TEST(Simplify, LeavesFaultsAlone) {
  Soup soup = sheet(12);
  soup.triangles.push_back({0, 0, 1});                        // degenerate
  soup.triangles.push_back(soup.triangles[100]);              // duplicate: three non-manifold edges
  soup.triangles.push_back({50, 51, 168});                    // a fin
  std::swap(soup.triangles[200][0], soup.triangles[200][1]);  // turned over
  const Simplification result = simplify(soup, {0.02, BoundaryPolicy::move});
  EXPECT_EQ(result.left_out.degenerate_triangles, 1U);
  EXPECT_GT(result.left_out.non_manifold_vertices, 0U);
  expect_leads_back(result.mesh, soup);
}

TEST(Simplify, LargeFansAreSimplifiedAwayAndSplitFromSmallOnesOnly) {
  for (const auto& [name, soup] : {std::pair{"double cone", double_cone(4000)},
                                   {"open cone", open_cone(4000)},
                                   {"cylinder", cylinder(4000)},
                                   {"disc", disc(4000, 3)}}) {
    SCOPED_TRACE(name);
    const Simplification away = simplify(soup, {0.02, BoundaryPolicy::move});
    EXPECT_LE(away.mesh.base.size(), away.wanted_triangles);
    EXPECT_EQ(away.left_out.large_vertices, 0U);
    expect_leads_back(away.mesh, soup);

    const Simplification some = simplify(soup, {0.3, BoundaryPolicy::move});
    EXPECT_LE(some.mesh.base.size(), some.wanted_triangles);
    EXPECT_GT(some.left_out.large_vertices, 0U);
    StripMesh mesh = StripMesh::build(some.mesh.base, some.mesh.points.size());
    for (const Record& record : some.mesh.splits) {
      ASSERT_LE(spoke_count(mesh, record.v_s), 2 * Simplifier::most_neighbors);
      mesh.insert_vertex(spokes_of(mesh, record), record.v_t);
    }
  }
}

class RealMeshes : public testing::TestWithParam<const char*> {};

TEST_P(RealMeshes, LeadBack) {
  const auto file = REAL_MESH(GetParam());
  const Soup soup = read_mesh(file);
  for (const BoundaryPolicy policy : {BoundaryPolicy::lock, BoundaryPolicy::move})
    expect_leads_back(simplify(soup, {0.02, policy}).mesh, soup);
}

INSTANTIATE_TEST_SUITE_P(Simplify, RealMeshes,
                         testing::Values("fandisk.obj", "rocker-arm.obj", "beetle_nm.obj", "dragon_vrip_res3.ply",
                                         "teapot6320.obj", "bad/blobby-shuffled.off", "bad/data_cow.obj",
                                         "bad/testdata_deg_faces.obj", "bad/testdata_test_nm.obj", "bad/venus.obj",
                                         "bad/models_joined_tetrahedra.obj"));

}  // namespace
}  // namespace restrip::tools
