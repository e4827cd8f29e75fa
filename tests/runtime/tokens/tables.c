/* Every function of the emitted restrip_tables.h: all colours of small fans with a bit too many, positions beside those
   that there are. Prints digests of the answers. */
#include <stdio.h>

#define RESTRIP_TABLES_IMPLEMENTATION
#include "restrip_tables.h"

static uint32_t digest;

static void add(uint32_t number) { digest = digest * UINT32_C(1000003) + number; }

static void tell(restrip_rule rule) {
  add(rule.colors);
  add((uint32_t)rule.strips);
  add(rule.valid);
}

static void ask(uint32_t k, uint32_t p, uint32_t q, uint32_t colors, uint32_t ports) {
  tell(restrip_open_split(k, p, q, colors, ports));
  tell(restrip_open_collapse(k, p, q, colors, ports));
  if (q != 0) return;
  tell(restrip_split(k, p, colors, ports));
  tell(restrip_collapse(k, p, colors, ports));
  tell(restrip_boundary_split(k, p, colors, ports));
  tell(restrip_boundary_collapse(k, p, colors, ports));
}

int main(void) {
  uint32_t k, p, q, colors, ports;
  for (k = 0; k <= RESTRIP_TABLES_MAX_K + 1; ++k) {
    const uint32_t color_bits = k > RESTRIP_TABLES_MAX_K ? 3 : k + 4;
    const uint32_t port_bits = k > RESTRIP_TABLES_MAX_K ? 1 : k < 5 ? k + 1 : k;
    digest = 0;
    for (p = 0; p <= k + 1; ++p)
      for (q = 0; q <= k + 1; ++q)
        for (colors = 0; colors >> color_bits == 0; ++colors)
          for (ports = 0; ports >> port_bits == 0; ++ports) ask(k, p, q, colors, ports);
    ask(k, 1, 2, UINT32_C(0x80000000), 0);
    ask(k, 1, 2, 0, UINT32_C(0x80000000));
    printf("%u %08x\n", (unsigned)k, (unsigned)digest);
  }
  digest = 0;
  for (colors = 0; colors <= 4; ++colors)
    for (ports = 0; ports <= 33; ++ports) {
      const restrip_flip_rule rule = restrip_flip(colors, ports);
      add(rule.inner);
      add(rule.ports);
      add((uint32_t)rule.strips);
      add(rule.valid);
    }
  printf("flip %08x\n", (unsigned)digest);
  return 0;
}
