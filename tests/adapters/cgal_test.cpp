// CGAL's Euler operations on a Surface_mesh, with strips: the same as StripMesh, edge by edge. Its edge_collapse with
// our visitor keeps the strips, and tells how many there are; without the visitor it breaks them, and debug builds say
// so.
#include "throwing_checks.hpp"
// That one first.
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Count_stop_predicate.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Edge_length_cost.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Midpoint_placement.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>

#include "../runtime/sample_meshes.hpp"
#include "decimation.hpp"
#include "lockstep.hpp"
#include "restrip/mesh/adapters/cgal.hpp"
#include "restrip/operations/adapters/cgal_edge_collapse.hpp"
#include "restrip/operations/test_adapter.hpp"

namespace restrip {
namespace {

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
static_assert(SplittableMesh<SurfaceMeshStrips<Point>> && CollapsibleMesh<SurfaceMeshStrips<Point>> &&
              FlippableMesh<SurfaceMeshStrips<Point>> && NumberedMesh<SurfaceMeshStrips<Point>>);

class Foreign {
 public:
  using Halfedge = Mesh::Halfedge_index;
  using Vertex = Mesh::Vertex_index;
  explicit Foreign(const StripMesh& from)
      : mesh_(copy_of<Mesh>(
            from, [](restrip::Vertex v) { return Point(v, 0, 0); }, [](restrip::Vertex v) { return Vertex(v); })),
        strips_(mesh_) {}
  SurfaceMeshStrips<Point>& strips() { return strips_; }
  Vertex vertex(restrip::Vertex v) const { return Vertex(v); }
  Halfedge find(Vertex v, Vertex w) const { return mesh_.halfedge(v, w); }
  bool exists(Halfedge h) const { return h.is_valid() && !mesh_.is_border(h); }
  Vertex from(Halfedge h) const { return mesh_.source(h); }
  Vertex to(Halfedge h) const { return mesh_.target(h); }
  template <class Visit>
  void for_each_triangle(Visit&& visit) const {
    for (const auto f : mesh_.faces()) visit(mesh_.halfedge(f));
  }

 private:
  Mesh mesh_;
  SurfaceMeshStrips<Point> strips_;
};

TEST(CgalAdapter, ClosedMesh) { walk_in_lockstep<Foreign>(sample::torus(12, 10), false, 1); }
TEST(CgalAdapter, MeshWithBoundary) { walk_in_lockstep<Foreign>(sample::rectangle(6, 5), true, 2); }

TEST(CgalAdapter, KeepsTheContract) {
  for (const StripMesh& from : {sample::torus(7, 6), sample::rectangle(6, 5)}) {
    Mesh mesh = copy_of<Mesh>(
        from, [](restrip::Vertex v) { return Point(v, 0, 0); },
        [](restrip::Vertex v) { return Mesh::Vertex_index(v); });
    SurfaceMeshStrips<Point> strips(mesh);
    const AdapterReport report = test_adapter(strips, strips.halfedge(0));
    EXPECT_TRUE(report.kept()) << describe(report.broken) << " (" << report.during << ")";
    EXPECT_GT(report.splits + report.collapses, 200U);
  }
}

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
