/* Maintains strips from C: a sheet is stripified and simplified by collapses under a policy, and its live index buffer
 * reports the changes. Every function that can fail returns a code; a refused operation changes nothing. */
#include <restrip.h>
#include <stdio.h>
#include <stdlib.h>

enum { N = 40 }; /* squares a side */

static void check(restrip_status status) {
  if (status == RESTRIP_OK) return;
  fprintf(stderr, "restrip: %s\n", restrip_describe(status));
  exit(1);
}

static restrip_mesh* sheet(void) {
  static uint32_t indices[6 * N * N];
  uint32_t* out = indices;
  uint32_t x, y;
  restrip_mesh* mesh;
  for (y = 0; y < N; ++y)
    for (x = 0; x < N; ++x) {
      const uint32_t a = y * (N + 1) + x, b = a + 1, c = a + N + 2, d = a + N + 1;
      *out++ = a, *out++ = b, *out++ = c;
      *out++ = a, *out++ = c, *out++ = d;
    }
  check(restrip_mesh_build_u32(indices, 6 * N * N, (N + 1) * (N + 1), NULL, NULL, &mesh));
  return mesh;
}

static void print(const restrip_mesh* mesh) {
  restrip_coloring found;
  restrip_buffer* buffer;
  restrip_buffer_view view;
  const restrip_format format = {RESTRIP_FORM_RESTART, 16, 0, 0, 1};
  check(restrip_mesh_check(mesh, &found));
  check(restrip_mesh_buffer(mesh, NULL, &format, &buffer));
  check(restrip_buffer_read(buffer, &view));
  printf("%d triangles, %d strips, %d indices\n", (int)found.triangles, (int)found.strips, (int)view.index_count);
  restrip_buffer_free(buffer);
}

int main(void) {
  const restrip_format format = {RESTRIP_FORM_RESTART, 16, 0, 0, 1};
  const restrip_range* ranges;
  restrip_buffer_view view;
  size_t range_count, i, written = 0;
  uint32_t v;
  int strips = 0;
  restrip_mesh* mesh = sheet();

  if (restrip_abi_version() != RESTRIP_ABI_VERSION) return 1;
  print(mesh);
  check(restrip_mesh_stripify(mesh, RESTRIP_EFFORT_FULL, NULL, 0, NULL));
  print(mesh);

  check(restrip_mesh_keep(mesh, RESTRIP_POLICY_QUICK, NULL));
  check(restrip_live_begin(mesh, &format, NULL, 0));
  check(restrip_live_update(mesh, 2, 4, &ranges, &range_count, NULL));
  for (v = 0; restrip_mesh_triangle_count(mesh) > N * N; ++v) {
    restrip_change change;
    const restrip_halfedge spoke = restrip_mesh_spoke(mesh, v);
    if (restrip_mesh_collapse(mesh, spoke, &change) == RESTRIP_OK) strips += (int)change.strips;
  }
  printf("collapses changed the number of strips by %+d\n", strips);
  print(mesh);

  check(restrip_live_update(mesh, 2, 4, &ranges, &range_count, NULL)); /* what is to be copied to the device */
  for (i = 0; i < range_count; ++i) written += ranges[i].count;
  check(restrip_live_buffer(mesh, &view, NULL));
  printf("live buffer: %s\n", written <= view.index_count && view.indices != NULL ? "in step" : "wrong");

  v = (uint32_t)restrip_mesh_vertex_bound(mesh) - 1;
  printf("a flip at the corner: %s\n", restrip_describe(restrip_mesh_flip(mesh, restrip_mesh_spoke(mesh, v), NULL)));
  restrip_mesh_free(mesh);
  return 0;
}
