/* Asks restrip_tables.h everything, and prints digests of what it answers, as `restrip-dump-tables --digests` does.
     cc restrip_tables_check.c && ./a.out [K [OPERATIONS]]
   A line for each operation, 0 to 6, and position: "operation k p q digest". The position of a split or collapse of a
   closed fan is p = a; in an open fan p = i and q = j; unused ones are 0. The look-up is compiled into this program. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define RESTRIP_TABLES_IMPLEMENTATION
#include "restrip_tables.h"

static const char* wanted = "0123456"; /* operations */

static uint32_t packed(bool valid, uint32_t colors, int32_t strips) {
  return valid ? UINT32_C(0x80000000) | (uint32_t)(strips + 8) << 16 | colors : 0;
}

static uint32_t answer(unsigned operation, uint32_t k, uint32_t p, uint32_t q, uint32_t before, uint32_t ports) {
  restrip_rule rule = {0, 0, false};
  if (operation == 6) {
    const restrip_flip_rule flip = restrip_flip(before, ports);
    return packed(flip.valid, flip.inner << 4 | flip.ports, flip.strips);
  }
  if (operation == 0) rule = restrip_split(k, p, before, ports);
  if (operation == 1) rule = restrip_collapse(k, p, before, ports);
  if (operation == 2) rule = restrip_open_split(k, p, q, before, ports);
  if (operation == 3) rule = restrip_open_collapse(k, p, q, before, ports);
  if (operation == 4) rule = restrip_boundary_split(k, p, before, ports);
  if (operation == 5) rule = restrip_boundary_collapse(k, p, before, ports);
  return packed(rule.valid, rule.colors, rule.strips);
}

static bool inside(unsigned operation, uint32_t k, uint32_t p, uint32_t q, uint32_t max_k) {
  if (k > max_k) return false;
  if (operation < 2) return k >= 3 && p >= 1 && p < k && q == 0;
  if (operation < 4) return k >= 1 && p < q && q <= k;
  return k >= 1 && p <= k && q == 0;
}

static uint32_t mix(uint32_t before, uint32_t ports, uint32_t answered) {
  uint32_t h = answered ^ before * UINT32_C(0x9e3779b1) ^ ports * UINT32_C(0x85ebca77);
  h = (h ^ h >> 16) * UINT32_C(0x85ebca6b);
  h = (h ^ h >> 13) * UINT32_C(0xc2b2ae35);
  return h ^ h >> 16;
}

static void line(unsigned operation, uint32_t k, uint32_t p, uint32_t q, uint32_t before_bits, uint32_t port_bits) {
  uint32_t digest = 0, before, ports;
  if (strchr(wanted, (int)('0' + operation)) == NULL) return;
  for (before = 0; before >> before_bits == 0; ++before)
    for (ports = 0; ports >> port_bits == 0; ++ports)
      digest += mix(before, ports, answer(operation, k, p, q, before, ports));
  printf("%u %u %u %u %08x\n", operation, (unsigned)k, (unsigned)p, (unsigned)q, (unsigned)digest);
}

int main(int argc, char** argv) {
  static const int32_t more_bits[6] = {0, 3, -1, 2, -1, 0}; /* colours before, more than k */
  const uint32_t max_k = argc > 1 ? (uint32_t)strtoul(argv[1], NULL, 10) : RESTRIP_TABLES_MAX_K;
  uint32_t k, p, q, outside = 0;
  unsigned operation;
  if (argc > 2) wanted = argv[2];
  for (operation = 0; operation < 6; ++operation)
    for (k = 0; k < 20; ++k)
      for (p = 0; p < 20; ++p)
        for (q = 0; q < 20; ++q) {
          if (inside(operation, k, p, q, max_k))
            line(operation, k, p, q, (uint32_t)((int32_t)k + more_bits[operation]), k);
          else if (!inside(operation, k, p, operation / 2 == 1 ? q : 0, RESTRIP_TABLES_MAX_K))
            outside += answer(operation, k, p, q, 0, 0) != 0 ? 1 : 0;
        }
  line(6, 0, 0, 0, 1, 4);
  outside += answer(6, 0, 0, 0, 2, 0) != 0 || answer(6, 0, 0, 0, 0, 16) != 0 ? 1 : 0;
  printf("rules outside the tables: %u\n", (unsigned)outside);
  return 0;
}
