// CGAL's Euler operations on a Surface_mesh, with strips: the same as StripMesh, edge by edge.
#include "restrip/adapters/cgal.hpp"

#include <CGAL/Simple_cartesian.h>

#include "../runtime/sample_meshes.hpp"
#include "lockstep.hpp"

namespace restrip {
namespace {

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
static_assert(SplittableMesh<SurfaceMeshStrips<Point>> && CollapsibleMesh<SurfaceMeshStrips<Point>> &&
              FlippableMesh<SurfaceMeshStrips<Point>>);

class Foreign {
 public:
  using Halfedge = Mesh::Halfedge_index;
  using Vertex = Mesh::Vertex_index;
  explicit Foreign(const StripMesh& from) : mesh_(copy(from)), strips_(mesh_) {}
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
  static Mesh copy(const StripMesh& from) {
    Mesh mesh;
    for (restrip::Vertex v = 0; v < from.vertex_bound(); ++v) mesh.add_vertex(Point(v, 0, 0));
    for (Triangle t = 0; t < from.triangle_bound(); ++t) {
      const auto [a, b, c] = from.corners(t);
      mesh.add_face(Vertex(a), Vertex(b), Vertex(c));
    }
    return mesh;
  }
  Mesh mesh_;
  SurfaceMeshStrips<Point> strips_;
};

void walk(const StripMesh& start, bool boundary, unsigned seed) {
  Foreign foreign(start);
  Lockstep<Foreign> both(start, foreign, seed);
  both.run(6000);
  if (boundary) {
    EXPECT_GT(both.one_sided(), 5);
  }
}

TEST(CgalAdapter, ClosedMesh) { walk(sample::torus(12, 10), false, 1); }
TEST(CgalAdapter, MeshWithBoundary) { walk(sample::rectangle(6, 5), true, 2); }

}  // namespace
}  // namespace restrip
