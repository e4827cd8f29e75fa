// CGAL's edge_collapse with strips: a visitor that does each collapse on a LiveMesh as well, by vertex numbers.
//
// CGAL calls a visitor before it collapses v0 into v1. The live mesh does the same collapse. The buffer is compared
// with the triangles of CGAL after every hundred collapses.
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_simplification/Edge_collapse_visitor_base.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Count_ratio_stop_predicate.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>

#include <cstdint>
#include <cstdio>

#include "mirror.hpp"
#include "restrip/live_mesh.hpp"

namespace {

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
namespace simplification = CGAL::Surface_mesh_simplification;

Triangles triangles_of(const Mesh& mesh) {
  Triangles list;
  for (const auto face : mesh.faces()) {
    auto& t = list.emplace_back();
    std::size_t i = 0;
    for (const auto v : mesh.vertices_around_face(mesh.halfedge(face))) t[i++] = std::uint32_t(v);
  }
  return sorted(std::move(list));
}
/// CGAL copies visitors; the copies share what `shared` points to.
class StripVisitor : public simplification::Edge_collapse_visitor_base<Mesh> {
 public:
  struct Shared {
    restrip::LiveMesh& live;
    std::size_t collapses = 0;
    std::size_t refused = 0;
    std::size_t frames = 0;
    std::size_t same = 0;
  };
  explicit StripVisitor(Shared& shared) : shared_(&shared) {}

  template <class Profile, class Placement>
  void OnCollapsing(const Profile& profile, const Placement& /*placement*/) {
    if (!shared_->live.collapse(std::uint32_t(profile.v1()), std::uint32_t(profile.v0()))) ++shared_->refused;
  }
  template <class Profile>
  void OnCollapsed(const Profile& profile, Mesh::Vertex_index /*kept*/) {
    if (++shared_->collapses % 100 != 0) return;
    (void)shared_->live.update();
    ++shared_->frames;
    shared_->same += drawn(shared_->live.indices()) == triangles_of(profile.surface_mesh()) ? 1U : 0U;
  }

 private:
  Shared* shared_;
};

}  // namespace

int main() {
  Mesh mesh;
  const StartMesh start = bumpy_torus();
  for (const auto& [x, y, z] : start.points) mesh.add_vertex(Point(x, y, z));
  for (const auto& [a, b, c] : start.triangles)
    mesh.add_face(Mesh::Vertex_index(a), Mesh::Vertex_index(b), Mesh::Vertex_index(c));

  restrip::LiveMesh live(indices_of(start.triangles), mesh.num_vertices());
  StripVisitor::Shared shared{live};
  simplification::edge_collapse(mesh, simplification::Count_ratio_stop_predicate<Mesh>(0.2),
                                CGAL::parameters::visitor(StripVisitor(shared)));
  std::printf("%zu triangles left, the live mesh has %zu; %zu collapses refused\n", mesh.number_of_faces(),
              live.mesh().triangle_count(), shared.refused);
  std::printf("%zu frames, %zu drawn as CGAL has them\n", shared.frames, shared.same);
  return shared.frames > 0 && shared.same == shared.frames && shared.refused == 0 ? 0 : 1;
}
