// CGAL's Euler operations on a Surface_mesh, with strips: the same as StripMesh, edge by edge.
#include "throwing_checks.hpp"
// That one first.
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include "lockstep.hpp"
#include "restrip/mesh/adapters/cgal.hpp"

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
  static std::uint32_t number(Vertex v) { return static_cast<std::uint32_t>(v.idx()); }
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

TEST(CgalAdapter, KeepsTheContract) { expect_contract_kept<Foreign>(); }

}  // namespace
}  // namespace restrip
