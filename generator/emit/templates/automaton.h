// restrip's rules for fans of any valence up to @max_k@: an automaton, @bytes@ bytes of data, and the look-up.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 The restrip authors
// Written by `restrip-generate automaton --language c`. Do not edit: change the generator.
//
@operations@
//
// Each function takes the key of a patch (restrip's docs/reference/notation.md, "Key") and returns best colours after the operation:
// sound whatever lies outside the patch, with the fewest strips, and of those the fewest isolated triangles. Masks have bit
// 0 the lowest, 1 = solid, 0 = dashed; docs/reference/notation.md says which bit is which edge. Each takes two table reads
// for a triangle.
//
// Include this file wherever you need the declarations. In exactly one source file write
//     #define RESTRIP_AUTOMATON_IMPLEMENTATION
// before the include: there are the data and the bodies. Nothing is allocated, no library is called, nothing is written.
//
// Bad input: any masks are safe. Bits at k and above, and bits of `joined` without a solid port, are ignored. For
// positions that are not listed above, the answer's colours are 0 and `valid` is false.
#ifndef RESTRIP_AUTOMATON_H
#define RESTRIP_AUTOMATON_H

#include <stdbool.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

// The largest valence whose colours fit a word.
#define RESTRIP_AUTOMATON_MAX_K @max_k@

// `joined`: bit i is set when port i is joined, before the operation, to the solid port before it.
typedef struct restrip_key {
  uint64_t ports, joined;
} restrip_key;

// The inner edges after the operation. The number of strips grows by the triangles added, less the solid edges added.
typedef struct restrip_recoloring {
  uint64_t colors;
  bool valid;
} restrip_recoloring;

restrip_recoloring restrip_best_split(uint32_t k, uint32_t a, restrip_key key);
restrip_recoloring restrip_best_collapse(uint32_t k, restrip_key key);
restrip_recoloring restrip_best_open_split(uint32_t k, uint32_t i, uint32_t j, restrip_key key);
restrip_recoloring restrip_best_boundary_split(uint32_t k, uint32_t i, restrip_key key);
restrip_recoloring restrip_best_fan_collapse(uint32_t k, restrip_key key);

#ifdef __cplusplus
}
#endif

#endif  // RESTRIP_AUTOMATON_H

#ifdef RESTRIP_AUTOMATON_IMPLEMENTATION
#undef RESTRIP_AUTOMATON_IMPLEMENTATION

// The arrays of restrip's tables/include/restrip/tables/automaton_format.hpp, which explains them; but of `before` each
// number is two words, the word of the low cases first, and `next` holds 0 where a letter is not allowed.
#define RESTRIP_LETTERS 4U
#define RESTRIP_SECONDS @seconds@U
@arrays@

// An arc: its class, and the entries of its letters.
typedef struct restrip_arc {
  uint32_t arc_class, size;
  uint32_t entries[RESTRIP_AUTOMATON_MAX_K + 1];
} restrip_arc;

static uint64_t restrip_low_bits(uint32_t n) { return (UINT64_C(1) << n) - 1; }

// With exactly two solid ports in a closed fan either bit of `joined` stands for the pair, from both sides. In an open
// fan nothing lies before the first solid port.
static restrip_key restrip_key_in_fan(uint32_t k, restrip_key key, bool closed) {
  const uint64_t ports = key.ports & restrip_low_bits(k), but_one = ports & (ports - 1);
  key.ports = ports;
  key.joined &= closed ? ports : but_one;
  if (closed && key.joined != 0 && but_one != 0 && (but_one & (but_one - 1)) == 0) key.joined = ports;
  return key;
}

static uint32_t restrip_letter(restrip_key key, uint32_t i) {
  return (uint32_t)(key.ports >> i & 1) + (uint32_t)(key.joined >> i & 1);
}

static void restrip_read(restrip_arc* arc, uint32_t letter) {
  const uint32_t entry = RESTRIP_LETTERS * arc->arc_class + letter;
  arc->entries[arc->size++] = entry;
  arc->arc_class = restrip_next[entry];
}

static void restrip_read_fan(restrip_arc* arc, restrip_key key, uint32_t from, uint32_t to) {
  for (; from < to; ++from) restrip_read(arc, restrip_letter(key, from));
}

// The links of an arc, bit m the link after m letters, from the case of the whole arc.
static uint64_t restrip_links(const restrip_arc* arc, uint32_t end) {
  uint64_t links = 0;
  for (uint32_t m = arc->size; m > 0; --m) {
    if ((end & 3) != 0) links |= UINT64_C(1) << m;
    end = restrip_before[2 * arc->entries[m - 1] + (end >> 3)] >> 4 * (end & 7) & 15;
  }
  return links | ((end & 3) != 0 ? 1U : 0U);
}

// The links of an arc that goes over the boundary of an open fan after `above` triangles, as edges of the path that
// begins after the boundary; the first link is edge `from`. The boundary has no edges.
static uint64_t restrip_links_around(const restrip_arc* arc, uint32_t end, uint32_t above, uint32_t from) {
  const uint64_t links = restrip_links(arc, end);
  return (links & restrip_low_bits(above)) << from | links >> (above + 2);
}

// How an arc between A and D and one between D and A meet: their cases, and the chord.
static uint32_t restrip_meeting(const restrip_arc* one, const restrip_arc* other) {
  return restrip_meetings[restrip_meet[RESTRIP_SECONDS * restrip_first[one->arc_class] + restrip_second[other->arc_class]]];
}

static const restrip_recoloring restrip_no_recoloring = {0, false};

static restrip_recoloring restrip_recoloring_of(uint64_t colors) {
  const restrip_recoloring made = {colors, true};
  return made;
}

restrip_recoloring restrip_best_split(uint32_t k, uint32_t a, restrip_key key) {
  restrip_arc one = {0, 0, {0}}, other = {0, 0, {0}};
  if (k < 3 || k > RESTRIP_AUTOMATON_MAX_K || a < 1 || a >= k) return restrip_no_recoloring;
  key = restrip_key_in_fan(k, key, true);
  restrip_read_fan(&one, key, 0, a);
  restrip_read_fan(&other, key, a, k);
  const uint32_t meeting = restrip_meeting(&one, &other);
  return restrip_recoloring_of(restrip_links(&one, meeting & 15) | restrip_links(&other, meeting >> 4 & 15) << (a + 1) |
                               (uint64_t)(meeting >> 8) << (k + 2));
}

restrip_recoloring restrip_best_collapse(uint32_t k, restrip_key key) {
  restrip_arc whole = {0, 0, {0}};
  if (k < 3 || k > RESTRIP_AUTOMATON_MAX_K) return restrip_no_recoloring;
  restrip_read_fan(&whole, restrip_key_in_fan(k, key, true), 0, k);
  return restrip_recoloring_of(restrip_links(&whole, restrip_closed[whole.arc_class]) >> 1);  // the first link is the last
}

restrip_recoloring restrip_best_open_split(uint32_t k, uint32_t i, uint32_t j, restrip_key key) {
  restrip_arc one = {0, 0, {0}}, other = {0, 0, {0}};
  if (k < 1 || k > RESTRIP_AUTOMATON_MAX_K || i >= j || j > k) return restrip_no_recoloring;
  key = restrip_key_in_fan(k, key, false);
  restrip_read_fan(&one, key, i, j);
  restrip_read_fan(&other, key, j, k);
  restrip_read(&other, RESTRIP_LETTERS - 1);
  restrip_read_fan(&other, key, 0, i);
  const uint32_t meeting = restrip_meeting(&one, &other);
  return restrip_recoloring_of(restrip_links(&one, meeting & 15) << i |
                               restrip_links_around(&other, meeting >> 4 & 15, k - j, j + 1) |
                               (uint64_t)(meeting >> 8) << (k + 1));
}

restrip_recoloring restrip_best_boundary_split(uint32_t k, uint32_t i, restrip_key key) {
  restrip_arc arc = {0, 0, {0}};
  if (k < 1 || k > RESTRIP_AUTOMATON_MAX_K || i > k) return restrip_no_recoloring;
  key = restrip_key_in_fan(k, key, false);
  restrip_read_fan(&arc, key, 0, i);
  restrip_read(&arc, 0);  // A is a triangle without a port
  restrip_read_fan(&arc, key, i, k);
  return restrip_recoloring_of(restrip_links(&arc, 0) >> 1);
}

restrip_recoloring restrip_best_fan_collapse(uint32_t k, restrip_key key) {
  restrip_arc arc = {0, 0, {0}};
  if (k < 1 || k > RESTRIP_AUTOMATON_MAX_K) return restrip_no_recoloring;
  restrip_read_fan(&arc, restrip_key_in_fan(k, key, false), 0, k);
  return restrip_recoloring_of(restrip_links(&arc, 0) >> 1);
}
#endif  // RESTRIP_AUTOMATON_IMPLEMENTATION
