/* Asks restrip_tables.h everything, and prints digests of what it answers, as `restrip-dump-tables --digests` does.
     cc restrip_tables_check.c && ./a.out [K [OPERATIONS]]
   A line for each operation, 0, 1 and 6, and position: "operation k p q digest". The position of a split or collapse is
   p = a; unused ones are 0. The look-up is compiled into this program. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define RESTRIP_TABLES_IMPLEMENTATION
#include "restrip_tables.h"

static const char* wanted = "016"; /* operations */

static uint32_t packed(bool valid, uint32_t colors, int32_t strips) {
  return valid ? UINT32_C(0x80000000) | (uint32_t)(strips + 8) << 16 | colors : 0;
}

static uint32_t answer(unsigned operation, uint32_t k, uint32_t p, uint32_t before, uint32_t ports) {
  restrip_rule rule;
  if (operation == 6) {
    const restrip_flip_rule flip = restrip_flip(before, ports);
    return packed(flip.valid, flip.inner << 4 | flip.ports, flip.strips);
  }
  rule = operation == 0 ? restrip_split(k, p, before, ports) : restrip_collapse(k, p, before, ports);
  return packed(rule.valid, rule.colors, rule.strips);
}

static bool inside(uint32_t k, uint32_t p, uint32_t max_k) { return k >= 3 && k <= max_k && p >= 1 && p < k; }

static uint32_t mix(uint32_t before, uint32_t ports, uint32_t answered) {
  uint32_t h = answered ^ before * UINT32_C(0x9e3779b1) ^ ports * UINT32_C(0x85ebca77);
  h = (h ^ h >> 16) * UINT32_C(0x85ebca6b);
  h = (h ^ h >> 13) * UINT32_C(0xc2b2ae35);
  return h ^ h >> 16;
}

static void line(unsigned operation, uint32_t k, uint32_t p, uint32_t before_bits, uint32_t port_bits) {
  uint32_t digest = 0, before, ports;
  if (strchr(wanted, (int)('0' + operation)) == NULL) return;
  for (before = 0; before >> before_bits == 0; ++before)
    for (ports = 0; ports >> port_bits == 0; ++ports)
      digest += mix(before, ports, answer(operation, k, p, before, ports));
  printf("%u %u %u 0 %08x\n", operation, (unsigned)k, (unsigned)p, (unsigned)digest);
}

int main(int argc, char** argv) {
  const uint32_t max_k = argc > 1 ? (uint32_t)strtoul(argv[1], NULL, 10) : RESTRIP_TABLES_MAX_K;
  uint32_t k, p, outside = 0;
  unsigned operation;
  if (argc > 2) wanted = argv[2];
  for (operation = 0; operation < 2; ++operation)
    for (k = 0; k < 20; ++k)
      for (p = 0; p < 20; ++p) {
        if (inside(k, p, max_k))
          line(operation, k, p, operation == 0 ? k : k + 3, k);
        else if (!inside(k, p, RESTRIP_TABLES_MAX_K))
          outside += answer(operation, k, p, 0, 0) != 0 ? 1 : 0;
      }
  line(6, 0, 0, 1, 4);
  outside += answer(6, 0, 0, 2, 0) != 0 || answer(6, 0, 0, 0, 16) != 0 ? 1 : 0;
  printf("rules outside the tables: %u\n", (unsigned)outside);
  return 0;
}
