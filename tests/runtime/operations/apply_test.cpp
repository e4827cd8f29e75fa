// apply() does what an operation file says: on a StripMesh the triangles are those that are worked out on a bare list;
// its check grants just the operations that leave the mesh as good. live_random_test.cpp counts what they report.
#include "restrip/operations/apply.hpp"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "applied_lists.hpp"
#include "restrip/operations/operations.hpp"
#include "restrip/operations/refine.hpp"
#include "restrip/tables/shipped_operations.hpp"
#include "sample_meshes.hpp"
#include "triangle_list.hpp"

namespace restrip {
namespace {

using Halfedge = StripMesh::Halfedge;

// At every halfedge of small meshes, among them such with vertices of two and three triangles and non-manifold ones.
TEST(Apply, DoesWhatTheFileSaysWhereItMay) {
  std::vector<StripMesh> meshes{sample::octahedron(),        sample::rectangle(4, 3), sample::tube(4, 4),
                                sample::torus(4, 5),         sample::sphere(1),       sample::double_cone(3),
                                sample::open_double_cone(3), sample::tetrahedron()};
  meshes.push_back(StripMesh::build(std::vector<bare::Corners>{{0, 1, 2}, {0, 2, 3}, {0, 3, 1}}, 4));
  meshes.push_back(StripMesh::build(std::vector<bare::Corners>{{0, 1, 2}, {2, 1, 3}, {4, 5, 0}, {0, 6, 4}}, 7));
  // Vertices of three triangles, and of two on the boundary.
  for (const auto& [mesh, t] : {std::pair{sample::torus(4, 5), 3U}, {sample::rectangle(4, 3), 2U}}) {
    meshes.push_back(mesh);
    apply(meshes.back(), tables::split_face_rules, StripMesh::halfedge(t));
    apply(meshes.back(), tables::split_face_rules, StripMesh::halfedge(t));
    for (Triangle u = 0; u < mesh.triangle_bound(); ++u)
      checked_apply(meshes.back(), tables::bisect_boundary_rules, StripMesh::halfedge(u, 1));
    checked_apply(meshes.back(), tables::bisect_rules, StripMesh::halfedge(0));
    meshes.back().clear_colors();  // pairs are wanted as well as strips
  }
  tables::for_each_operation([&](const char* name, const auto& table) {
    std::size_t granted = 0;
    for (const StripMesh& mesh : meshes)
      granted += try_everywhere(
          mesh, [&](Halfedge) -> const auto& { return table; });
    EXPECT_GT(granted, 5U) << name;
    for (const StripMesh& mesh : sample::meshes())
      for (Triangle t = 0; t < mesh.triangle_bound(); ++t) {
        StripMesh copy = mesh;
        if (checked_apply(copy, table, StripMesh::halfedge(t))) {
          EXPECT_EQ(fault_of(copy), "") << name;
        }
      }
  });
}

// Coarsening and refining again gives the same handles.
TEST(Apply, TakesBackTheHandlesThatItGave) {
  StripMesh mesh = sample::torus(5, 5);
  const Halfedge h = StripMesh::halfedge(7, 1);
  const Halfedge first = apply(mesh, tables::split_face_rules, h).halfedge;
  const std::vector<bare::Corners> refined = sample::triangles_of(mesh);
  const std::size_t bound = mesh.triangle_bound();
  const Halfedge apex = mesh.next(mesh.next(first));  // m -> a
  const auto joined = apply(mesh, tables::join_faces_rules, apex);
  EXPECT_EQ(mesh.triangle_count(), 50U);
  EXPECT_EQ(StripMesh::triangle(joined.halfedge), StripMesh::triangle(apex));
  apply(mesh, tables::split_face_rules, joined.halfedge);
  EXPECT_EQ(sample::triangles_of(mesh), refined);
  EXPECT_EQ(mesh.triangle_bound(), bound);
}

// An operation with a border side fits in at most one orientation of a triangle. A brute-force count of the sheet knows
// where: at corners with two triangles, seen from the side that leads from the corner into the mesh.
TEST(Apply, AnywhereFindsTheOrientationThatFits) {
  std::size_t found = 0;
  for (unsigned seed = 0; seed < 20; ++seed) {
    const StripMesh mesh = sample::rectangle(6, 5, seed);
    for (Triangle t = 0; t < mesh.triangle_bound(); ++t) {
      Halfedge fitting = StripMesh::halfedge(t);
      std::size_t ways = 0;
      for (unsigned s = 0; s < 3; ++s) {
        // `m b c`, with m b on the boundary, m of two triangles, and `a m c` next to it across m c.
        const Halfedge h = StripMesh::halfedge(t, s);
        const Halfedge beyond = mesh.opposite(StripMesh::next(StripMesh::next(h)));
        if (!StripMesh::on_boundary(mesh.opposite(h)) || StripMesh::on_boundary(beyond) ||
            !StripMesh::on_boundary(mesh.opposite(StripMesh::next(StripMesh::next(beyond)))) ||
            check_apply(mesh, tables::merge_boundary_rules, h) != Refusal::granted)
          continue;
        if (ways++ == 0) fitting = h;
      }
      ASSERT_EQ(first_place(mesh, tables::merge_boundary_rules, t), fitting);
      found += ways == 0 || fitting == StripMesh::halfedge(t) ? 0U : 1U;
    }
  }
  EXPECT_GT(found, 20U);
  const StripMesh torus = sample::torus(5, 5);
  EXPECT_EQ(first_place(torus, tables::merge_boundary_rules, 7), StripMesh::halfedge(7));
  EXPECT_EQ(first_place(torus, tables::split_face_rules, 50), Halfedge{});
}

TEST(Apply, RefusesWithAReason) {
  const StripMesh rectangle = sample::rectangle(4, 3);
  EXPECT_EQ(check_apply(rectangle, tables::split_face_rules, {none}), Refusal::no_such_edge);
  Halfedge rim = StripMesh::halfedge(0);
  while (!StripMesh::on_boundary(rectangle.opposite(rim))) rim = StripMesh::next(rim);
  EXPECT_EQ(check_apply(rectangle, tables::split_face_rules, rectangle.opposite(rim)), Refusal::boundary_edge);
  EXPECT_EQ(check_apply(rectangle, tables::bisect_rules, rim), Refusal::other_patch);
  EXPECT_EQ(check_apply(rectangle, tables::bisect_boundary_rules, rim), Refusal::granted);
  EXPECT_EQ(check_apply(sample::torus(5, 5), tables::bisect_boundary_rules, StripMesh::halfedge(0)),
            Refusal::other_patch);
  EXPECT_EQ(check_apply(sample::octahedron(), tables::join_faces_rules, StripMesh::halfedge(0)), Refusal::other_patch);
  const StripMesh tetrahedron = sample::tetrahedron();
  EXPECT_EQ(check_apply(tetrahedron, tables::join_faces_rules, StripMesh::halfedge(0)), Refusal::too_few_triangles);
  EXPECT_EQ(check_apply(tetrahedron, tables::flip_matching_rules, StripMesh::halfedge(0)), Refusal::edge_exists);
  EXPECT_EQ(check_apply(sample::meshes().back(), tables::split_face_rules, StripMesh::halfedge(0)),
            Refusal::non_manifold_vertex);
  // By name; which patches fit: live_random_test.cpp.
  for (const OperationPlace& at :
       {split_face_at(rectangle, {}), join_faces_at(rectangle, {}), bisect_at(rectangle, {}), merge_at(rectangle, {})})
    EXPECT_EQ(check_apply(rectangle, at), Refusal::no_such_edge);
  EXPECT_EQ(check_apply(rectangle, split_face_at(rectangle, rectangle.opposite(rim))), Refusal::boundary_edge);
  EXPECT_EQ(check_apply(rectangle, bisect_at(rectangle, rectangle.opposite(rim))), Refusal::granted);
  EXPECT_EQ(check_apply(sample::octahedron(), join_faces_at(sample::octahedron(), StripMesh::halfedge(0))),
            Refusal::other_patch);
  StripMesh bad = sample::torus(5, 5);
  for (unsigned s = 0; s < 3; ++s) bad.set_solid(StripMesh::halfedge(0, s), true);
  EXPECT_EQ(check_apply(bad, tables::split_face_rules, StripMesh::halfedge(0)), Refusal::colors_not_valid);
}

}  // namespace
}  // namespace restrip
