// CGAL's edge_collapse with our visitor keeps the strips, and tells how many there are; without the visitor it breaks
// them, and debug builds say so.
#include "throwing_checks.hpp"
// That one first.
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Count_stop_predicate.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Edge_length_cost.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Midpoint_placement.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>

#include "decimation.hpp"
#include "lockstep.hpp"
#include "restrip/operations/adapters/cgal_edge_collapse.hpp"

namespace restrip {
namespace {

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
namespace sms = CGAL::Surface_mesh_simplification;

Mesh copy_of(const Placed& from) {
  return copy_of<Mesh>(
      from.mesh,
      [&](restrip::Vertex v) {
        const auto& [x, y, z] = from.points[v];
        return Point(x, y, z);
      },
      [](restrip::Vertex v) { return Mesh::Vertex_index(v); });
}

/// To a quarter of its edges.
template <class Visitor>
void simplify(Mesh& mesh, const Visitor& visitor) {
  sms::edge_collapse(mesh, sms::Count_stop_predicate<Mesh>(mesh.number_of_edges() / 4),
                     CGAL::parameters::get_cost(sms::Edge_length_cost<Mesh>())
                         .get_placement(sms::Midpoint_placement<Mesh>())
                         .visitor(visitor));
}

void expect_edge_collapse_keeps(const Placed& start) {
  std::size_t kept = start.mesh.triangle_count();
  for (const HookRules rules : {HookRules::local, HookRules::linked}) {
    Mesh mesh = copy_of(start);
    SurfaceMeshStrips<Point> strips(mesh);
    take_colors(strips, start.mesh);
    const ColoringReport before = check_coloring(strips);
    HookTally tally;
    simplify(mesh, StripVisitor(strips, tally, rules));
    expect_kept(strips, before, tally);
    EXPECT_LT(check_coloring(strips).strips, kept);  // the same triangles in fewer strips by linked rules
    kept = check_coloring(strips).strips;
  }
}

TEST(CgalEdgeCollapse, KeepsStripsOfMadeMeshes) {
  expect_edge_collapse_keeps(bumpy_torus(40, 30));
  expect_edge_collapse_keeps(bumpy_sheet(30, 30));
}
TEST(CgalEdgeCollapse, KeepsStripsOfRockerArm) {
  const auto file = REAL_MESH("rocker-arm.obj");
  expect_edge_collapse_keeps(read_placed(file));
}
TEST(CgalEdgeCollapse, KeepsStripsOfBunnyWithItsHoles) {
  const auto file = REAL_MESH("bunny.obj");
  expect_edge_collapse_keeps(read_placed(file));
}
TEST(CgalEdgeCollapse, BreaksThemWithoutTheVisitor) {
  const Placed start = bumpy_torus(40, 30);
  Mesh mesh = copy_of(start);
  SurfaceMeshStrips<Point> strips(mesh);
  take_colors(strips, start.mesh);
  simplify(mesh, sms::Edge_collapse_visitor_base<Mesh>());
  expect_broken(strips);
}
// CGAL collapses edges without length before it tells a visitor anything.
TEST(CgalEdgeCollapse, ColorsStayValidWhereNothingIsTold) {
  Placed start = bumpy_torus(40, 30);
  for (std::size_t v = 0; v + 1 < start.points.size(); v += 5) start.points[v] = start.points[v + 1];
  Mesh mesh = copy_of(start);
  SurfaceMeshStrips<Point> strips(mesh);
  take_colors(strips, start.mesh);
  HookTally tally;
  simplify(mesh, StripVisitor(strips, tally));
  EXPECT_GT(tally.untold, 100U);
  EXPECT_GT(tally.operations, 100U);
  EXPECT_TRUE(check_coloring(strips).valid);
}

}  // namespace
}  // namespace restrip
