/* The tetrahedron of main.cpp, in C. */
#include <restrip.h>
#include <stddef.h>

int main(void) {
  const uint16_t indices[] = {0, 1, 2, 0, 2, 3, 0, 3, 1, 1, 3, 2};
  restrip_mesh* mesh;
  restrip_change change;
  restrip_coloring found;
  if (restrip_abi_version() != RESTRIP_ABI_VERSION) return 1;
  if (restrip_mesh_build_u16(indices, 12, 4, NULL, NULL, &mesh) != RESTRIP_OK) return 2;
  if (restrip_mesh_split(mesh, restrip_mesh_find(mesh, 0, 1), restrip_mesh_find(mesh, 0, 2), RESTRIP_NONE, &change) !=
      RESTRIP_OK)
    return 3;
  if (restrip_mesh_check(mesh, &found) != RESTRIP_OK || found.triangles != 6 || !found.valid) return 4;
  if (restrip_mesh_collapse(mesh, change.halfedge, NULL) != RESTRIP_OK || restrip_mesh_triangle_count(mesh) != 4)
    return 5;
  if (restrip_mesh_collapse(NULL, 0, NULL) != RESTRIP_NULL_ARGUMENT) return 6;
  restrip_mesh_free(mesh);
  return 0;
}
