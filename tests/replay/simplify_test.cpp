// Claims: simplification reaches its target where collapses allow it, its splits lead back to exactly the triangles of
// the soup, and what is no manifold is left alone and counted.
#include "simplify.hpp"

#include <gtest/gtest.h>

#include "coloring_check.hpp"
#include "made_mesh.hpp"
#include "mesh_file.hpp"
#include "real_meshes.hpp"
#include "restrip/checks.hpp"
#include "shapes.hpp"

namespace restrip::replay {
namespace {

/// Splits the base back up, each split checked, and compares.
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
  EXPECT_EQ(sorted_triangles(triangles_of(mesh)), sorted_triangles(soup.triangles));
}

TEST(Simplify, ClosedMeshReachesItsTarget) {
  const Soup soup = make_mesh(4000);
  const Simplification result = simplify(soup, {0.05, BoundaryPolicy::move});
  EXPECT_LE(result.mesh.base.size(), result.wanted_triangles);
  EXPECT_GT(result.mesh.base.size() + 2, result.wanted_triangles);
  EXPECT_EQ(result.mesh.fine_triangles(), soup.triangles.size());
  expect_leads_back(result.mesh, soup);
}

TEST(Simplify, BoundaryMovesOrStays) {
  const Soup soup = sheet(20);
  const auto base_boundary = [&](BoundaryPolicy policy) {
    const Simplification result = simplify(soup, {0.05, policy});
    expect_leads_back(result.mesh, soup);
    BuildReport report;
    (void)StripMesh::build(result.mesh.base, result.mesh.points.size(), &report);
    return report.boundary_edges;
  };
  EXPECT_EQ(base_boundary(BoundaryPolicy::lock), 80U);
  EXPECT_LT(base_boundary(BoundaryPolicy::move), 80U);
}

TEST(Simplify, LockedBoundaryHasClosedFansOnly) {
  for (const Record& record : simplify(sheet(20), {0.05, BoundaryPolicy::lock}).mesh.splits) {
    EXPECT_NE(record.v_l, none);
    EXPECT_NE(record.v_r, none);
  }
}

TEST(Simplify, WholeMeshNeedsNoSplit) {
  const Simplification result = simplify(tetrahedron(), {1.0, BoundaryPolicy::move});
  EXPECT_EQ(result.mesh.base.size(), 4U);
  EXPECT_TRUE(result.mesh.splits.empty());
}

TEST(Simplify, StopsWhereNoCollapseIsLegal) {
  const Simplification result = simplify(tetrahedron(), {0.1, BoundaryPolicy::move});
  EXPECT_EQ(result.mesh.base.size(), 4U);
  EXPECT_EQ(result.wanted_triangles, 1U);
}

TEST(Simplify, LeavesFaultsAlone) {
  Soup soup = sheet(12);
  soup.triangles.push_back({0, 0, 1});                        // degenerate
  soup.triangles.push_back(soup.triangles[100]);              // duplicate: three non-manifold edges
  soup.triangles.push_back({50, 51, 168});                    // a fin
  std::swap(soup.triangles[200][0], soup.triangles[200][1]);  // turned over
  const Simplification result = simplify(soup, {0.02, BoundaryPolicy::move});
  EXPECT_EQ(result.left_out.degenerate_triangles, 1U);
  EXPECT_GT(result.left_out.irregular_vertices, 0U);
  expect_leads_back(result.mesh, soup);
}

TEST(Simplify, IsDeterministic) {
  const Soup soup = make_mesh(2000);
  EXPECT_EQ(simplify(soup).mesh.splits, simplify(soup).mesh.splits);
}

class RealMeshes : public testing::TestWithParam<const char*> {};

TEST_P(RealMeshes, LeadBack) {
  if (real_mesh(GetParam()).empty()) GTEST_SKIP() << GetParam() << " is not to be had: set RESTRIP_MESHES";
  const Soup soup = read_mesh(real_mesh(GetParam()));
  for (const BoundaryPolicy policy : {BoundaryPolicy::lock, BoundaryPolicy::move})
    expect_leads_back(simplify(soup, {0.02, policy}).mesh, soup);
}

INSTANTIATE_TEST_SUITE_P(Simplify, RealMeshes,
                         testing::Values("fandisk.obj", "rocker-arm.obj", "beetle_nm.obj", "dragon_vrip_res3.ply",
                                         "teapot6320.obj", "bad/blobby-shuffled.off", "bad/data_cow.obj",
                                         "bad/testdata_deg_faces.obj", "bad/testdata_test_nm.obj", "bad/venus.obj",
                                         "bad/models_joined_tetrahedra.obj"));

}  // namespace
}  // namespace restrip::replay
