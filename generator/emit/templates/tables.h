// restrip's rule tables up to k = @max_k@: @bytes@ bytes of data, and the look-up.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 The restrip authors
// Written by `restrip-generate tables --language c --max-k @max_k@`. Do not edit: change the generator.
//
@operations@
//
// Each function takes the colours of a patch before an operation and returns the best colours after it: sound
// whatever lies outside the patch, with the fewest strips, and of those with the fewest isolated triangles. Colours
// are masks, bit 0 the lowest, 1 = solid, 0 = dashed; restrip's docs/reference/notation.md says which bit is which edge. Each
// takes O(k) steps.
//
// Include this file wherever you need the declarations. In exactly one source file write
//     #define RESTRIP_TABLES_IMPLEMENTATION
// before the include: there are the data and the bodies. Nothing is allocated, no library is called, nothing is written.
//
// Bad input: for colours that no valid stripification has (three solid edges at a triangle, a solid cycle, bits outside
// the patch), and for positions that the tables do not hold (k > RESTRIP_TABLES_MAX_K, a out of range), every
// member of the answer is 0 and `valid` is false.
#ifndef RESTRIP_TABLES_H
#define RESTRIP_TABLES_H

#include <stdbool.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

// The largest valence that the tables answer.
#define RESTRIP_TABLES_MAX_K @max_k@

// `colors` are the inner edges after the operation, `strips` the change in the number of strips.
typedef struct restrip_rule {
  uint32_t colors;
  int32_t strips;
  bool valid;
} restrip_rule;

// The inner edge after a flip, and the ports that stay solid: a flip may have to give some up.
typedef struct restrip_flip_rule {
  uint32_t inner;
  uint32_t ports;
  int32_t strips;
  bool valid;
} restrip_flip_rule;

restrip_rule restrip_split(uint32_t k, uint32_t a, uint32_t loop, uint32_t ports);
restrip_rule restrip_collapse(uint32_t k, uint32_t a, uint32_t inner, uint32_t ports);
restrip_flip_rule restrip_flip(uint32_t inner, uint32_t ports);

#ifdef __cplusplus
}
#endif

#endif  // RESTRIP_TABLES_H

#ifdef RESTRIP_TABLES_IMPLEMENTATION
#undef RESTRIP_TABLES_IMPLEMENTATION

// The rules of an operation depend on its position and on the key (ports, joined). The cell of a key is
//     rules[first[k] + place * cells[k] + rows[1 << k | ports] + joined]
// with one packing for all rules.
@arrays@

// The patch before an operation as a ring of elements: the k triangles of the fan in order, with A at element `a` and D
// at element `d`, or restrip_nowhere. Inner edge m joins elements m and m + 1, the last one the last element and the
// first. The chord A - D has the bit after the edges.
typedef struct restrip_patch {
  uint32_t k, a, d;
} restrip_patch;

#define restrip_nowhere UINT32_C(31)

static uint32_t restrip_low(uint32_t n) { return (UINT32_C(1) << n) - 1; }
static bool restrip_has(uint32_t mask, uint32_t i) { return (mask >> i & 1) != 0; }
static uint32_t restrip_size(restrip_patch p) {
  return p.k + (p.a != restrip_nowhere ? 1U : 0U) + (p.d != restrip_nowhere ? 1U : 0U);
}
static bool restrip_has_chord(restrip_patch p, uint32_t inner) {
  return p.d != restrip_nowhere && restrip_has(inner, restrip_size(p));
}

static int32_t restrip_count(uint32_t mask) {
  int32_t n = 0;
  for (; mask != 0; mask &= mask - 1) ++n;
  return n;
}

// Turns a ring of n bits so that bit `by` becomes bit 0.
static uint32_t restrip_turned(uint32_t mask, uint32_t by, uint32_t n) {
  return (mask >> by | mask << (n - by)) & restrip_low(n);
}

static uint32_t restrip_insert_zero(uint32_t mask, uint32_t at) {
  const uint32_t below = restrip_low(at);
  return (mask & below) | (mask & ~below) << 1;
}
static uint32_t restrip_remove_bit(uint32_t mask, uint32_t at) {
  const uint32_t below = restrip_low(at);
  return (mask & below) | (mask >> 1 & ~below);
}

// Ports as a mask over elements.
static uint32_t restrip_spread(restrip_patch p, uint32_t ports) {
  return restrip_insert_zero(restrip_insert_zero(ports, p.a), p.d);
}

// At most two solid edges at every element, no solid cycle, no bit outside the patch.
static bool restrip_valid(restrip_patch p, uint32_t inner, uint32_t ports) {
  const uint32_t size = restrip_size(p);
  const uint32_t all = restrip_low(restrip_size(p));
  const uint32_t edges = inner & all;
  const uint32_t below = edges << 1 | edges >> (size - 1);
  const uint32_t between = restrip_low(p.d) & ~restrip_low(p.a);  // with a chord: the edges from A up to D
  const bool chord = restrip_has_chord(p, inner);
  const uint32_t ends = chord ? UINT32_C(1) << p.a | UINT32_C(1) << p.d : 0;
  if (inner >> restrip_size(p) > (chord ? 1U : 0U) || ports >> p.k != 0) return false;
  if ((edges & below & (restrip_spread(p, ports) | ends)) != 0 || edges == all) return false;
  return !chord || ((~edges & between) != 0 && (~edges & all & ~between) != 0);
}

// The element at which the strand from element `at` ends, which has exactly one solid edge among `edges`.
static uint32_t restrip_strand_end(restrip_patch p, uint32_t edges, uint32_t at) {
  if (restrip_has(edges, at)) {
    while (restrip_has(edges, at)) ++at;
    return at;
  }
  if (at == 0) at = restrip_size(p);  // downwards from the first element
  while (at > 0 && restrip_has(edges, at - 1)) --at;
  return at;
}

// The pair of ports (by element) that a path over the chord joins, as the bit that names it in a key: the bit of the port
// that comes after the other, with no solid port between them. 0 if no such pair exists.
static uint32_t restrip_joined_by_chord(restrip_patch p, uint32_t edges, uint32_t ports) {
  const uint32_t below_a = p.a > 0 ? p.a - 1 : restrip_size(p) - 1;
  const bool a_goes_on = restrip_has(edges, below_a) != restrip_has(edges, p.a);
  const bool d_goes_on = restrip_has(edges, p.d - 1) != restrip_has(edges, p.d);
  if (!a_goes_on || !d_goes_on) return 0;
  const uint32_t one = restrip_strand_end(p, edges, p.a);
  const uint32_t two = restrip_strand_end(p, edges, p.d);
  if (!restrip_has(ports, one) || !restrip_has(ports, two)) return 0;
  const uint32_t low = one < two ? one : two;
  const uint32_t high = one < two ? two : one;
  const uint32_t within = restrip_low(high + 1) & ~restrip_low(low);
  if (restrip_count(ports & within) == 2) return UINT32_C(1) << high;
  return (ports & ~within) == 0 ? UINT32_C(1) << low : 0;
}

// Bit i is set when port i is solid and a solid path inside leads to the solid port before it. Adding the solid ports
// at which a strand begins upwards to the edges sends a carry through each run of solid edges, to the element where it
// ends. With exactly two solid ports each comes before the other: either bit stands for the pair.
static uint32_t restrip_joined(restrip_patch p, uint32_t inner, uint32_t fan_ports) {
  const uint32_t size = restrip_size(p);
  const uint32_t ports = restrip_spread(p, fan_ports);
  const uint32_t edges = inner & restrip_low(restrip_size(p));
  uint32_t ends = edges + (ports & edges);
  ends = (ends & restrip_low(size)) + (ends >> size);  // the carry goes round
  uint32_t joined = ends & ~edges & ports;
  if (restrip_has_chord(p, inner)) joined |= restrip_joined_by_chord(p, edges, ports);
  return restrip_remove_bit(restrip_remove_bit(joined, p.d), p.a);
}

// The place of a key in the block of its valence and position.
static uint32_t restrip_key_of(restrip_patch p, uint32_t inner, uint32_t ports) {
  return restrip_closed_rows[UINT32_C(1) << p.k | ports] + restrip_joined(p, inner, ports);
}

static const restrip_rule restrip_no_rule = {0, 0, false};

static restrip_rule restrip_rule_of(uint32_t colors, uint32_t before, int32_t new_triangles) {
  const restrip_rule rule = {colors, new_triangles - restrip_count(colors) + restrip_count(before), true};
  return rule;
}

restrip_rule restrip_split(uint32_t k, uint32_t a, uint32_t loop, uint32_t ports) {
  const restrip_patch fan = {k, restrip_nowhere, restrip_nowhere};
  if (k < 3 || k > RESTRIP_TABLES_MAX_K || a < 1 || a >= k || !restrip_valid(fan, loop, ports)) return restrip_no_rule;
  // The tables have the positions whose first arc is the shorter one. In the others A and D change places, and the fan
  // is turned until it begins with the second arc.
  const bool exchange = 2 * a > k;
  const uint32_t arc = exchange ? k - a : a;
  const uint32_t by = exchange ? a : 0;
  const uint32_t cell = restrip_split_rules[restrip_split_first[k] + (arc - 1) * restrip_split_cells[k] +
                                            restrip_key_of(fan, restrip_turned(loop, by, k), restrip_turned(ports, by, k))];
  const uint32_t ring = restrip_turned(cell & restrip_low(k + 2), exchange ? arc + 1 : 0, k + 2);
  return restrip_rule_of(ring | (cell & UINT32_C(1) << (k + 2)), loop, 2);
}

restrip_rule restrip_collapse(uint32_t k, uint32_t a, uint32_t inner, uint32_t ports) {
  const restrip_patch ring = {k, 0, a + 1};
  if (k < 3 || k > RESTRIP_TABLES_MAX_K || a < 1 || a >= k || !restrip_valid(ring, inner, ports)) return restrip_no_rule;
  return restrip_rule_of(restrip_collapse_rules[restrip_collapse_first[k] + restrip_key_of(ring, inner, ports)],
                         inner, -2);
}

restrip_flip_rule restrip_flip(uint32_t inner, uint32_t ports) {
  restrip_flip_rule rule = {0, 0, 0, false};
  if (inner > 1 || ports > 15) return rule;
  const uint32_t entry = restrip_flip_rules[inner << 4 | ports];  // the new inner edge above the ports kept
  if (entry == 255) return rule;
  rule.inner = entry >> 4;
  rule.ports = entry & 15;
  rule.strips = restrip_count(inner) + restrip_count(ports) - restrip_count(entry);
  rule.valid = true;
  return rule;
}
#endif  // RESTRIP_TABLES_IMPLEMENTATION
