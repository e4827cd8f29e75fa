// An OpenMesh decimater with strips: a module that does each collapse on a LiveMesh as well, by vertex numbers.
//
// OpenMesh calls a module before each collapse of v0 into v1. The live mesh does the same one, so after each frame its
// buffer draws the triangles that OpenMesh has. Here both are compared after every hundred collapses.
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>
#include <cstdint>
#include <cstdio>

#include "mirror.hpp"
#include "restrip/live_mesh.hpp"
#include "restrip/mesh/checks.hpp"

namespace {

using Mesh = OpenMesh::TriMesh_ArrayKernelT<>;

/// Accepts every collapse that the live mesh would do, and does it there.
template <class MeshT>
class ModStripsT : public OpenMesh::Decimater::ModBaseT<MeshT> {
 public:
  DECIMATING_MODULE(ModStripsT, MeshT, Strips);
  explicit ModStripsT(MeshT& mesh) : Base(mesh, true) {}

  void set(restrip::LiveMesh& live) { live_ = &live; }
  float collapse_priority(const CollapseInfo& info) override {
    const restrip::Halfedge chord = live_->edge(number(info.v1), number(info.v0));
    return restrip::check_collapse(live_->mesh(), chord) == restrip::Refusal::granted ? Base::LEGAL_COLLAPSE
                                                                                      : Base::ILLEGAL_COLLAPSE;
  }
  void preprocess_collapse(const CollapseInfo& info) override { live_->collapse(number(info.v1), number(info.v0)); }

 private:
  static std::uint32_t number(OpenMesh::VertexHandle v) { return static_cast<std::uint32_t>(v.idx()); }
  restrip::LiveMesh* live_ = nullptr;
};

Triangles triangles_of(const Mesh& mesh) {
  Triangles list;
  for (const auto face : mesh.faces()) {
    auto& t = list.emplace_back();
    std::size_t i = 0;
    for (const auto v : face.vertices()) t[i++] = static_cast<std::uint32_t>(v.idx());
  }
  return sorted(std::move(list));
}

}  // namespace

int main() {
  Mesh mesh;
  const StartMesh start = bumpy_torus();
  for (const auto& [x, y, z] : start.points) mesh.add_vertex({float(x), float(y), float(z)});
  for (const auto& [a, b, c] : start.triangles)
    mesh.add_face(Mesh::VertexHandle(int(a)), Mesh::VertexHandle(int(b)), Mesh::VertexHandle(int(c)));

  restrip::LiveMesh live(indices_of(start.triangles), mesh.n_vertices());
  OpenMesh::Decimater::DecimaterT<Mesh> decimater(mesh);
  OpenMesh::Decimater::ModQuadricT<Mesh>::Handle quadric;
  ModStripsT<Mesh>::Handle strips;
  decimater.add(quadric);
  decimater.add(strips);
  decimater.module(strips).set(live);
  decimater.initialize();
  std::size_t frames = 0;
  std::size_t same = 0;
  while (decimater.decimate(100) > 0) {
    (void)live.update();
    same += drawn(live.indices()) == triangles_of(mesh) ? 1U : 0U;
    if (++frames % 5 == 0) std::printf("%zu triangles in %zu strips\n", live.mesh().triangle_count(), live.strips());
    if (live.mesh().triangle_count() < 500) break;
  }
  std::printf("%zu frames, %zu drawn as OpenMesh has them\n", frames, same);
  return same == frames ? 0 : 1;
}
