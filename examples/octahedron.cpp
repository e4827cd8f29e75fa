#include <cstdio>
#include <restrip/restrip.hpp>

int main() {
  // An octahedron; all dual edges dashed, every triangle a strip of its own.
  const std::array<restrip::Vertex, 3> faces[] = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                                                  {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  restrip::StripMesh mesh = restrip::StripMesh::build(faces, 6);
  const auto print = [&mesh] {  // an index buffer for GL, Vulkan or WebGPU, with primitive restart
    const restrip::Strips strips = restrip::extract_strips(mesh);
    const auto indices = restrip::strip_indices(mesh, strips);
    std::printf("%zu triangles, %zu strips, %zu indices\n", mesh.triangle_count(), strips.size(), indices.size());
  };
  print();
  // Split vertex 4 along its edges to 0 and 1. The rule colours the patch.
  const auto done = restrip::split(mesh, {mesh.spoke(4, 0), mesh.spoke(4, 1)});
  std::printf("the split changed the number of strips by %d\n", done.strips);
  print();
  restrip::collapse(mesh, done.halfedge);  // and back; the strips that the split made remain
  print();
}
