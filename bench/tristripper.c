/* rm_tristripper as a function from an index buffer to strips separated by restarts, with windings preserved. In C,
 * because its headers are. */
#include <string.h>

#include "rm_tristripper.h"

/* Writes at most 2 * count + 4 indices for `count` indices of a triangle list, and returns how many. */
size_t tristripper_indices(const unsigned* ids, size_t count, unsigned* out) {
  rm_tristripper_config config;
  memset(&config, 0, sizeof config);
  config.preserve_orientation = 1;
  rm_tristripper_strip* strips;
  rm_size n;
  rm_tristripper_create_strips(ids, count, &config, &strips, &n);
  size_t at = 0;
  for (rm_size k = 0; k < n; ++k) {
    if (k != 0) out[at++] = 0xFFFFFFFFu;
    memcpy(out + at, strips[k].ids, strips[k].ids_count * sizeof *out);
    at += strips[k].ids_count;
  }
  rm_tristripper_dispose_strips(strips, n);
  return at;
}
