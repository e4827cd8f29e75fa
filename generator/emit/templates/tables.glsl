// restrip's rule tables up to k = @max_k@: @bytes@ bytes of data, and the look-up.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 The restrip authors
// Written by `restrip-generate tables --language glsl --max-k @max_k@`. Do not edit: change the generator.
//
@operations@
//
// Each function takes the colours of a patch before an operation and returns the best colours after it: sound
// whatever lies outside the patch, with the fewest strips, and of those with the fewest isolated triangles. Colours
// are masks, bit 0 the lowest, 1 = solid, 0 = dashed; restrip's docs/reference/notation.md says which bit is which edge. Each
// takes O(k) steps.
//
// The data are in restrip_tables.bin, written by the same command: @words@ words of 32 bits, little-endian, to be
// copied into a storage buffer as they are. If restrip_words[0] is not RESTRIP_CHECKSUM, file and data do not
// belong together.
//
// Bad input: for colours that no valid stripification has (three solid edges at a triangle, a solid cycle, bits
// outside the patch), and for positions that the tables do not hold (k > RESTRIP_MAX_K, a out of range),
// every member of the answer is 0 and `valid` is false.
//
// It is for GLSL 4.30 or GLSL ES 3.10 and later. Declare before it, with whatever binding you like:
//     layout(std430, set = 0, binding = 0) readonly buffer RestripTables { uint restrip_words[]; };

const uint RESTRIP_MAX_K = @max_k@u;
const uint RESTRIP_CHECKSUM = @checksum@u;
@arrays@

// `colors` are the inner edges after the operation, `strips` the change in the number of strips.
struct RestripRule {
  uint colors;
  int strips;
  bool valid;
};

// The inner edge after a flip, and the ports that stay solid: a flip may have to give some up.
struct RestripFlipRule {
  uint inner;
  uint ports;
  int strips;
  bool valid;
};

// Element `index` of an array: `place` says with which word it begins and how many bits an element has.
uint restrip_element(uvec2 place, uint index) {
  uint bit = index * place.y;
  return (restrip_words[place.x + bit / 32u] >> (bit % 32u)) & (0xffffffffu >> (32u - place.y));
}

// The patch before an operation as a ring of elements: the k triangles of the fan in order, with A at element `a` and D
// at element `d`, or RESTRIP_NOWHERE. Inner edge m joins elements m and m + 1, the last one the last element and the
// first. The chord A - D has the bit after the edges.
struct RestripPatch {
  uint k;
  uint a;
  uint d;
};

const uint RESTRIP_NOWHERE = 31u;

uint restrip_low(uint n) { return (1u << n) - 1u; }
bool restrip_has(uint mask, uint i) { return ((mask >> i) & 1u) != 0u; }
uint restrip_size(RestripPatch p) { return p.k + uint(p.a != RESTRIP_NOWHERE) + uint(p.d != RESTRIP_NOWHERE); }
bool restrip_has_chord(RestripPatch p, uint inner) {
  return p.d != RESTRIP_NOWHERE && restrip_has(inner, restrip_size(p));
}

// Turns a ring of n bits so that bit `by` becomes bit 0.
uint restrip_turned(uint mask, uint by, uint n) { return ((mask >> by) | (mask << (n - by))) & restrip_low(n); }

uint restrip_insert_zero(uint mask, uint at) { return (mask & restrip_low(at)) | ((mask & ~restrip_low(at)) << 1u); }
uint restrip_remove_bit(uint mask, uint at) { return (mask & restrip_low(at)) | ((mask >> 1u) & ~restrip_low(at)); }

// Ports as a mask over elements.
uint restrip_spread(RestripPatch p, uint ports) {
  return restrip_insert_zero(restrip_insert_zero(ports, p.a), p.d);
}

// At most two solid edges at every element, no solid cycle, no bit outside the patch.
bool restrip_valid(RestripPatch p, uint inner, uint ports) {
  uint all = restrip_low(restrip_size(p));
  uint edges = inner & all;
  uint below = (edges << 1u) | (edges >> (restrip_size(p) - 1u));
  uint between = restrip_low(p.d) & ~restrip_low(p.a);  // with a chord: the edges from A up to D
  bool chord = restrip_has_chord(p, inner);
  uint ends = chord ? (1u << p.a) | (1u << p.d) : 0u;
  if ((inner >> restrip_size(p)) > uint(chord) || (ports >> p.k) != 0u) return false;
  if ((edges & below & (restrip_spread(p, ports) | ends)) != 0u || edges == all) return false;
  return !chord || ((~edges & between) != 0u && (~edges & all & ~between) != 0u);
}

// The element at which the strand from element `at` ends, which has exactly one solid edge among `edges`.
uint restrip_strand_end(RestripPatch p, uint edges, uint at) {
  if (restrip_has(edges, at)) return at + uint(findLSB(~(edges >> at)));
  if (at == 0u) at = restrip_size(p);  // downwards from the first element
  return at - (31u - uint(findMSB(~(edges << (32u - at)))));
}

// The pair of ports (by element) that a path over the chord joins, as the bit that names it in a key: the bit of the port
// that comes after the other, with no solid port between them. 0 if no such pair exists.
uint restrip_joined_by_chord(RestripPatch p, uint edges, uint ports) {
  uint below_a = p.a > 0u ? p.a - 1u : restrip_size(p) - 1u;
  bool a_goes_on = restrip_has(edges, below_a) != restrip_has(edges, p.a);
  bool d_goes_on = restrip_has(edges, p.d - 1u) != restrip_has(edges, p.d);
  if (!a_goes_on || !d_goes_on) return 0u;
  uint one = restrip_strand_end(p, edges, p.a);
  uint two = restrip_strand_end(p, edges, p.d);
  if (!restrip_has(ports, one) || !restrip_has(ports, two)) return 0u;
  uint within = restrip_low(max(one, two) + 1u) & ~restrip_low(min(one, two));
  if (bitCount(ports & within) == 2) return 1u << max(one, two);
  return (ports & ~within) == 0u ? 1u << min(one, two) : 0u;
}

// Bit i is set when port i is solid and a solid path inside leads to the solid port before it. Adding the solid ports
// at which a strand begins upwards to the edges sends a carry through each run of solid edges, to the element where it
// ends. With exactly two solid ports each comes before the other: either bit stands for the pair.
uint restrip_joined(RestripPatch p, uint inner, uint fan_ports) {
  uint ports = restrip_spread(p, fan_ports);
  uint edges = inner & restrip_low(restrip_size(p));
  uint ends = edges + (ports & edges);
  ends = (ends & restrip_low(restrip_size(p))) + (ends >> restrip_size(p));  // the carry goes round
  uint joined = ends & ~edges & ports;
  if (restrip_has_chord(p, inner)) joined |= restrip_joined_by_chord(p, edges, ports);
  return restrip_remove_bit(restrip_remove_bit(joined, p.d), p.a);
}

// The rules of an operation depend on its position and on the key (ports, joined). The cell of a key is
//     rules[first[k] + place * cells[k] + rows[1 << k | ports] + joined]
// with one packing for all rules. Here is the place of a key in the block of its valence and position.
uint restrip_key(RestripPatch p, uint inner, uint ports) {
  return restrip_element(RESTRIP_CLOSED_ROWS, (1u << p.k) | ports) + restrip_joined(p, inner, ports);
}

RestripRule restrip_no_rule() { return RestripRule(0u, 0, false); }

RestripRule restrip_rule(uint colors, uint before, int new_triangles) {
  return RestripRule(colors, new_triangles - bitCount(colors) + bitCount(before), true);
}

RestripRule restrip_split(uint k, uint a, uint loop_edges, uint ports) {
  RestripPatch fan = RestripPatch(k, RESTRIP_NOWHERE, RESTRIP_NOWHERE);
  if (k < 3u || k > RESTRIP_MAX_K || a < 1u || a >= k) return restrip_no_rule();
  if (!restrip_valid(fan, loop_edges, ports)) return restrip_no_rule();
  // The tables have the positions whose first arc is the shorter one. In the others A and D change places, and the fan
  // is turned until it begins with the second arc.
  bool exchange = 2u * a > k;
  uint arc = exchange ? k - a : a;
  uint by = exchange ? a : 0u;
  uint block = restrip_element(RESTRIP_SPLIT_FIRST, k) + (arc - 1u) * restrip_element(RESTRIP_SPLIT_CELLS, k);
  uint key = restrip_key(fan, restrip_turned(loop_edges, by, k), restrip_turned(ports, by, k));
  uint cell = restrip_element(RESTRIP_SPLIT_RULES, block + key);
  uint ring = restrip_turned(cell & restrip_low(k + 2u), exchange ? arc + 1u : 0u, k + 2u);
  return restrip_rule(ring | (cell & (1u << (k + 2u))), loop_edges, 2);
}

RestripRule restrip_collapse(uint k, uint a, uint inner, uint ports) {
  RestripPatch ring = RestripPatch(k, 0u, a + 1u);
  if (k < 3u || k > RESTRIP_MAX_K || a < 1u || a >= k) return restrip_no_rule();
  if (!restrip_valid(ring, inner, ports)) return restrip_no_rule();
  uint cell = restrip_element(RESTRIP_COLLAPSE_FIRST, k) + restrip_key(ring, inner, ports);
  return restrip_rule(restrip_element(RESTRIP_COLLAPSE_RULES, cell), inner, -2);
}

RestripFlipRule restrip_flip(uint inner, uint ports) {
  if (inner > 1u || ports > 15u) return RestripFlipRule(0u, 0u, 0, false);
  uint entry = restrip_element(RESTRIP_FLIP_RULES, (inner << 4u) | ports);  // the new inner edge above the ports kept
  if (entry == 255u) return RestripFlipRule(0u, 0u, 0, false);
  return RestripFlipRule(entry >> 4u, entry & 15u, bitCount(inner) + bitCount(ports) - bitCount(entry), true);
}
