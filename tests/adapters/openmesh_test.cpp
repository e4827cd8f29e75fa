// OpenMesh's own vertex_split, collapse and flip, with strips: the same as StripMesh, edge by edge.
#include "throwing_checks.hpp"
// That one first.
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include "lockstep.hpp"
#include "restrip/mesh/adapters/openmesh.hpp"

namespace restrip {
namespace {

using Mesh = OpenMesh::TriMesh_ArrayKernelT<>;
static_assert(SplittableMesh<OpenMeshStrips<Mesh>> && CollapsibleMesh<OpenMeshStrips<Mesh>> &&
              FlippableMesh<OpenMeshStrips<Mesh>> && NumberedMesh<OpenMeshStrips<Mesh>>);

class Foreign {
 public:
  using Halfedge = OpenMesh::HalfedgeHandle;
  using Vertex = OpenMesh::VertexHandle;
  explicit Foreign(const StripMesh& from)
      : mesh_(copy_of<Mesh>(
            from, [](restrip::Vertex v) { return Mesh::Point(static_cast<float>(v), 0, 0); },
            [](restrip::Vertex v) { return Vertex(static_cast<int>(v)); })),
        strips_(mesh_) {}
  OpenMeshStrips<Mesh>& strips() { return strips_; }
  Vertex vertex(restrip::Vertex v) const { return mesh_.vertex_handle(v); }
  Halfedge find(Vertex v, Vertex w) const { return mesh_.find_halfedge(v, w); }
  bool exists(Halfedge h) const { return h.is_valid() && !mesh_.is_boundary(h); }
  Vertex from(Halfedge h) const { return mesh_.from_vertex_handle(h); }
  Vertex to(Halfedge h) const { return mesh_.to_vertex_handle(h); }
  static std::uint32_t number(Vertex v) { return static_cast<std::uint32_t>(v.idx()); }
  template <class Visit>
  void for_each_triangle(Visit&& visit) const {
    for (const auto f : mesh_.faces()) visit(mesh_.halfedge_handle(f));
  }

 private:
  Mesh mesh_;
  OpenMeshStrips<Mesh> strips_;
};

TEST(OpenMeshAdapter, ClosedMesh) { walk_in_lockstep<Foreign>(sample::torus(12, 10), false, 1); }
TEST(OpenMeshAdapter, MeshWithBoundary) { walk_in_lockstep<Foreign>(sample::rectangle(6, 5), true, 2); }

TEST(OpenMeshAdapter, KeepsTheContract) { expect_contract_kept<Foreign>(); }

}  // namespace
}  // namespace restrip
