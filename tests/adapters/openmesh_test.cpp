// OpenMesh's own vertex_split, collapse and flip, with strips: the same as StripMesh, edge by edge.
#include "restrip/adapters/openmesh.hpp"

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include "../runtime/sample_meshes.hpp"
#include "lockstep.hpp"

namespace restrip {
namespace {

using Mesh = OpenMesh::TriMesh_ArrayKernelT<>;
static_assert(SplittableMesh<OpenMeshStrips<Mesh>> && CollapsibleMesh<OpenMeshStrips<Mesh>> &&
              FlippableMesh<OpenMeshStrips<Mesh>>);

class Foreign {
 public:
  using Halfedge = OpenMesh::HalfedgeHandle;
  using Vertex = OpenMesh::VertexHandle;
  explicit Foreign(const StripMesh& from) : mesh_(copy(from)), strips_(mesh_) {}
  OpenMeshStrips<Mesh>& strips() { return strips_; }
  Vertex vertex(restrip::Vertex v) const { return mesh_.vertex_handle(v); }
  Halfedge find(Vertex v, Vertex w) const { return mesh_.find_halfedge(v, w); }
  bool exists(Halfedge h) const { return h.is_valid() && !mesh_.is_boundary(h); }
  Vertex from(Halfedge h) const { return mesh_.from_vertex_handle(h); }
  Vertex to(Halfedge h) const { return mesh_.to_vertex_handle(h); }
  template <class Visit>
  void for_each_triangle(Visit&& visit) const {
    for (const auto f : mesh_.faces()) visit(mesh_.halfedge_handle(f));
  }

 private:
  static Mesh copy(const StripMesh& from) {
    Mesh mesh;
    for (restrip::Vertex v = 0; v < from.vertex_bound(); ++v) mesh.add_vertex(Mesh::Point(static_cast<float>(v), 0, 0));
    for (Triangle t = 0; t < from.triangle_bound(); ++t) {
      const auto [a, b, c] = from.corners(t);
      mesh.add_face(mesh.vertex_handle(a), mesh.vertex_handle(b), mesh.vertex_handle(c));
    }
    return mesh;
  }
  Mesh mesh_;
  OpenMeshStrips<Mesh> strips_;
};

void walk(const StripMesh& start, bool boundary, unsigned seed) {
  Foreign foreign(start);
  Lockstep<Foreign> both(start, foreign, seed);
  both.run(6000);
  if (boundary) {
    EXPECT_GT(both.one_sided(), 5);
  }
}

TEST(OpenMeshAdapter, ClosedMesh) { walk(sample::torus(12, 10), false, 1); }
TEST(OpenMeshAdapter, MeshWithBoundary) { walk(sample::rectangle(6, 5), true, 2); }

}  // namespace
}  // namespace restrip
