/* Asks restrip_automaton.h, and prints digests of what it answers, as `restrip-dump-tables --automaton --digests` does.
     cc restrip_automaton_check.c && ./a.out [K]
   A line for each operation, 0 split, 1 collapse, 2 open split, 3 fan collapse and 4 boundary split, and each position with
   k <= K, by default 28: "operation k p q digest". Where a position has at most 7,000 keys all are asked, else 64 that are
   drawn. The look-up is compiled into this program. */
#include <stdio.h>
#include <stdlib.h>

#define RESTRIP_AUTOMATON_IMPLEMENTATION
#include "restrip_automaton.h"

static uint32_t mix(uint32_t before, uint32_t ports, uint32_t answered) {
  uint32_t h = answered ^ before * UINT32_C(0x9e3779b1) ^ ports * UINT32_C(0x85ebca77);
  h = (h ^ h >> 16) * UINT32_C(0x85ebca6b);
  h = (h ^ h >> 13) * UINT32_C(0xc2b2ae35);
  return h ^ h >> 16;
}

/* How many keys are asked for a fan of k triangles. */
static uint32_t keys_of(uint32_t k) {
  uint32_t keys = 1;
  while (k-- > 0 && keys <= 7000) keys *= 3;
  return keys <= 7000 ? keys : 64;
}

static uint64_t drawn(uint32_t n, uint32_t i, uint32_t k) {
  return (mix(n, i, 0) | (uint64_t)mix(n, i + 8, 0) << 32) & ((UINT64_C(1) << k) - 1);
}

/* Key n: a letter for each port, the last one the lowest digit; or masks that are drawn. */
static restrip_key key_numbered(uint32_t k, uint32_t n, uint32_t keys) {
  restrip_key key = {0, 0};
  uint32_t i, letter;
  if (keys == 64) {
    key.ports = drawn(n, 0, k);
    key.joined = drawn(n, 1, k);
    return key;
  }
  for (i = k; i-- > 0; n /= 3) {
    letter = n % 3;
    if (letter == 0) continue;
    key.ports |= UINT64_C(1) << i;
    if (letter == 2) key.joined |= UINT64_C(1) << i;
  }
  return key;
}

static restrip_recoloring answer(uint32_t operation, uint32_t k, uint32_t p, uint32_t q, restrip_key key) {
  if (operation == 0) return restrip_best_split(k, p, key);
  if (operation == 1) return restrip_best_collapse(k, key);
  if (operation == 2) return restrip_best_open_split(k, p, q, key);
  if (operation == 3) return restrip_best_fan_collapse(k, key);
  return restrip_best_boundary_split(k, p, key);
}

static bool inside(uint32_t operation, uint32_t k, uint32_t p, uint32_t q, uint32_t max_k) {
  if (k < (operation < 2 ? 3U : 1U) || k > max_k) return false;
  if (operation == 0) return p >= 1 && p < k && q == 0;
  if (operation == 2) return p < q && q <= k;
  return q == 0 && (operation == 4 ? p <= k : p == 0);
}

static uint32_t folded(uint64_t mask) { return (uint32_t)mask ^ (uint32_t)(mask >> 32) * UINT32_C(0x9e3779b1); }

int main(int argc, char** argv) {
  const uint32_t max_k = argc > 1 ? (uint32_t)strtoul(argv[1], NULL, 10) : 28;
  const restrip_key none = {0, 0};
  uint32_t operation, k, p, q, n, keys, digest, outside = 0;
  for (operation = 0; operation < 5; ++operation)
    for (k = 0; k < 70; ++k)
      for (p = 0; p < 70; ++p)
        for (q = 0; q < 70; ++q) {
          if (!inside(operation, k, p, q, max_k)) {
            const bool counts = operation == 0 ? q == 0 : operation == 2 || (q == 0 && (operation == 4 || p == 0));
            if (counts && !inside(operation, k, p, q, RESTRIP_AUTOMATON_MAX_K) && answer(operation, k, p, q, none).valid) ++outside;
            continue;
          }
          digest = 0;
          keys = keys_of(k);
          for (n = 0; n < keys; ++n) {
            const restrip_key key = key_numbered(k, n, keys);
            const restrip_recoloring made = answer(operation, k, p, q, key);
            digest += mix(n, folded(key.ports), made.valid ? UINT32_C(0x80000000) | folded(made.colors) : 0);
          }
          printf("%u %u %u %u %08x\n", (unsigned)operation, (unsigned)k, (unsigned)p, (unsigned)q, (unsigned)digest);
        }
  printf("rules outside the tables: %u\n", (unsigned)outside);
  return 0;
}
