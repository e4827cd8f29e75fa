// CGAL's edge_collapse with our visitor maintains the strips and counts them; without the visitor it breaks them, and
// debug builds say so.
#include "throwing_checks.hpp"
// That one first.
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
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

/// CGAL has one of its own, and renamed it in version 6.
struct StopBelow {
  std::size_t edges;
  template <class Cost, class Profile>
  bool operator()(const Cost& /*cost*/, const Profile& /*profile*/, std::size_t /*first*/, std::size_t now) const {
    return now < edges;
  }
};

/// To a quarter of its edges.
template <class Visitor>
void simplify_by(Mesh& mesh, const Visitor& visitor) {
  sms::edge_collapse(mesh, StopBelow{mesh.number_of_edges() / 4},
                     CGAL::parameters::get_cost(sms::Edge_length_cost<Mesh>())
                         .get_placement(sms::Midpoint_placement<Mesh>())
                         .visitor(visitor));
}

struct CgalLibrary {
  using Strips = SurfaceMeshStrips<Point>;

  static Mesh copy_of(const Placed& from) {
    return restrip::copy_of<Mesh>(
        from.mesh,
        [&](restrip::Vertex v) {
          const auto& [x, y, z] = from.points[v];
          return Point(x, y, z);
        },
        [](restrip::Vertex v) { return Mesh::Vertex_index(v); });
  }
  static HookTally simplify(Mesh& mesh, Strips* strips) {
    HookTally tally;
    if (strips != nullptr)
      simplify_by(mesh, StripVisitor(*strips, tally));
    else
      simplify_by(mesh, sms::Edge_collapse_visitor_base<Mesh>());
    return tally;
  }
  static void collect(Mesh& /*mesh*/) {}
};

INSTANTIATE_TYPED_TEST_SUITE_P(Cgal, Decimation, CgalLibrary);

// CGAL collapses edges without length before it calls a visitor.
TEST(CgalEdgeCollapse, ColorsStayValidWithoutCallbacks) {
  Placed start = bumpy_torus(40, 30);
  for (std::size_t v = 0; v + 1 < start.points.size(); v += 5) start.points[v] = start.points[v + 1];
  Mesh mesh = CgalLibrary::copy_of(start);
  CgalLibrary::Strips strips(mesh);
  take_colors(strips, start.mesh);
  const HookTally tally = CgalLibrary::simplify(mesh, &strips);
  EXPECT_GT(tally.unannounced, 100U);
  EXPECT_GT(tally.operations, 100U);
  EXPECT_TRUE(check_coloring(strips).valid);
}

}  // namespace
}  // namespace restrip
