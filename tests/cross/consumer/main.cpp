// A tetrahedron, refined and coarsened again. The other file includes the same headers: nothing may be defined twice.
#include <array>
#include <restrip/restrip.hpp>
#include <vector>

std::size_t strips_elsewhere(const restrip::StripMesh& mesh);
bool splits_elsewhere(restrip::LiveMesh& live);

int main() {
  const std::vector<std::array<restrip::Vertex, 3>> triangles{{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}};
  restrip::StripMesh mesh = restrip::StripMesh::build(triangles, 4);
  const auto done = restrip::split(mesh, {mesh.spoke(0, 1), mesh.spoke(0, 2)});
  if (mesh.triangle_count() != 6 || !restrip::check_coloring(mesh).valid) return 1;
  restrip::collapse(mesh, done.halfedge);
  // In a container, which moves them.
  std::vector<restrip::LiveMesh> lives;
  for (int i = 0; i < 3; ++i) lives.emplace_back(triangles, 4, restrip::LiveOptions{.history = 100});
  for (restrip::LiveMesh& live : lives)
    if (!splits_elsewhere(live) || live.update().empty() || !live.undo() || live.mesh().triangle_count() != 4) return 2;
  return mesh.triangle_count() == 4 && strips_elsewhere(mesh) <= 4 ? 0 : 1;
}
