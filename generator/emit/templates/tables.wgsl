// restrip's rule tables up to k = @max_k@: @bytes@ bytes of data, and the look-up.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 The restrip authors
// Written by `restrip-generate tables --language wgsl --max-k @max_k@`. Do not edit: change the generator.
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
// Declare in the same module, with whatever binding you like:
//     @group(0) @binding(0) var<storage, read> restrip_words: array<u32>;

const RESTRIP_MAX_K = @max_k@u;
const RESTRIP_CHECKSUM = @checksum@u;
@arrays@

// `colors` are the inner edges after the operation, `strips` the change in the number of strips.
struct RestripRule {
  colors: u32,
  strips: i32,
  valid: bool,
}

// The inner edge after a flip, and the ports that stay solid: a flip may have to give some up.
struct RestripFlipRule {
  inner: u32,
  ports: u32,
  strips: i32,
  valid: bool,
}

// Element `index` of an array: `place` says with which word it begins and how many bits an element has.
fn restrip_element(place: vec2<u32>, index: u32) -> u32 {
  let bit = index * place.y;
  return (restrip_words[place.x + bit / 32u] >> (bit % 32u)) & (0xffffffffu >> (32u - place.y));
}

// The patch before an operation as a ring of elements: the k triangles of the fan in order, with A at element `a` and D
// at element `d`, or RESTRIP_NOWHERE. Inner edge m joins elements m and m + 1, the last one the last element and the
// first. The chord A - D has the bit after the edges.
struct RestripPatch {
  k: u32,
  a: u32,
  d: u32,
}

const RESTRIP_NOWHERE = 31u;

fn restrip_low(n: u32) -> u32 { return (1u << n) - 1u; }
fn restrip_has(mask: u32, i: u32) -> bool { return ((mask >> i) & 1u) != 0u; }
fn restrip_size(p: RestripPatch) -> u32 {
  return p.k + u32(p.a != RESTRIP_NOWHERE) + u32(p.d != RESTRIP_NOWHERE);
}
fn restrip_has_chord(p: RestripPatch, inner: u32) -> bool {
  return p.d != RESTRIP_NOWHERE && restrip_has(inner, restrip_size(p));
}

// Turns a ring of n bits so that bit `by` becomes bit 0.
fn restrip_turned(mask: u32, by: u32, n: u32) -> u32 {
  return ((mask >> by) | (mask << (n - by))) & restrip_low(n);
}

fn restrip_insert_zero(mask: u32, at: u32) -> u32 {
  return (mask & restrip_low(at)) | ((mask & ~restrip_low(at)) << 1u);
}
fn restrip_remove_bit(mask: u32, at: u32) -> u32 {
  return (mask & restrip_low(at)) | ((mask >> 1u) & ~restrip_low(at));
}

// Ports as a mask over elements.
fn restrip_spread(p: RestripPatch, ports: u32) -> u32 {
  return restrip_insert_zero(restrip_insert_zero(ports, p.a), p.d);
}

// At most two solid edges at every element, no solid cycle, no bit outside the patch.
fn restrip_valid(p: RestripPatch, inner: u32, ports: u32) -> bool {
  let all = restrip_low(restrip_size(p));
  let edges = inner & all;
  let below = (edges << 1u) | (edges >> (restrip_size(p) - 1u));
  let between = restrip_low(p.d) & ~restrip_low(p.a);  // with a chord: the edges from A up to D
  let chord = restrip_has_chord(p, inner);
  let ends = select(0u, (1u << p.a) | (1u << p.d), chord);
  if ((inner >> restrip_size(p)) > u32(chord) || (ports >> p.k) != 0u) {
    return false;
  }
  if ((edges & below & (restrip_spread(p, ports) | ends)) != 0u || edges == all) {
    return false;
  }
  return !chord || ((~edges & between) != 0u && (~edges & all & ~between) != 0u);
}

// The element at which the strand from element `at` ends, which has exactly one solid edge among `edges`.
fn restrip_strand_end(p: RestripPatch, edges: u32, at: u32) -> u32 {
  if (restrip_has(edges, at)) {
    return at + countTrailingZeros(~(edges >> at));
  }
  let from_above = select(at, restrip_size(p), at == 0u);  // downwards from the first element
  return from_above - countLeadingZeros(~(edges << (32u - from_above)));
}

// The pair of ports (by element) that a path over the chord joins, as the bit that names it in a key: the bit of the port
// that comes after the other, with no solid port between them. 0 if no such pair exists.
fn restrip_joined_by_chord(p: RestripPatch, edges: u32, ports: u32) -> u32 {
  let below_a = select(restrip_size(p), p.a, p.a > 0u) - 1u;
  let a_goes_on = restrip_has(edges, below_a) != restrip_has(edges, p.a);
  let d_goes_on = restrip_has(edges, p.d - 1u) != restrip_has(edges, p.d);
  if (!a_goes_on || !d_goes_on) {
    return 0u;
  }
  let one = restrip_strand_end(p, edges, p.a);
  let two = restrip_strand_end(p, edges, p.d);
  if (!restrip_has(ports, one) || !restrip_has(ports, two)) {
    return 0u;
  }
  let within = restrip_low(max(one, two) + 1u) & ~restrip_low(min(one, two));
  if (countOneBits(ports & within) == 2u) {
    return 1u << max(one, two);
  }
  return select(0u, 1u << min(one, two), (ports & ~within) == 0u);
}

// Bit i is set when port i is solid and a solid path inside leads to the solid port before it. Adding the solid ports
// at which a strand begins upwards to the edges sends a carry through each run of solid edges, to the element where it
// ends. With exactly two solid ports each comes before the other: either bit stands for the pair.
fn restrip_joined(p: RestripPatch, inner: u32, fan_ports: u32) -> u32 {
  let ports = restrip_spread(p, fan_ports);
  let edges = inner & restrip_low(restrip_size(p));
  var ends = edges + (ports & edges);
  ends = (ends & restrip_low(restrip_size(p))) + (ends >> restrip_size(p));  // the carry goes round
  var joined = ends & ~edges & ports;
  if (restrip_has_chord(p, inner)) {
    joined |= restrip_joined_by_chord(p, edges, ports);
  }
  return restrip_remove_bit(restrip_remove_bit(joined, p.d), p.a);
}

// The rules of an operation depend on its position and on the key (ports, joined). The cell of a key is
//     rules[first[k] + place * cells[k] + rows[1 << k | ports] + joined]
// with one packing for all rules. Here is the place of a key in the block of its valence and position.
fn restrip_key(p: RestripPatch, inner: u32, ports: u32) -> u32 {
  return restrip_element(RESTRIP_CLOSED_ROWS, (1u << p.k) | ports) + restrip_joined(p, inner, ports);
}

fn restrip_no_rule() -> RestripRule { return RestripRule(0u, 0, false); }

fn restrip_rule(colors: u32, before: u32, new_triangles: i32) -> RestripRule {
  return RestripRule(colors, new_triangles - i32(countOneBits(colors)) + i32(countOneBits(before)), true);
}

fn restrip_split(k: u32, a: u32, loop_edges: u32, ports: u32) -> RestripRule {
  let fan = RestripPatch(k, RESTRIP_NOWHERE, RESTRIP_NOWHERE);
  if (k < 3u || k > RESTRIP_MAX_K || a < 1u || a >= k) {
    return restrip_no_rule();
  }
  if (!restrip_valid(fan, loop_edges, ports)) {
    return restrip_no_rule();
  }
  // The tables have the positions whose first arc is the shorter one. In the others A and D change places, and the fan
  // is turned until it begins with the second arc.
  let exchange = 2u * a > k;
  let arc = select(a, k - a, exchange);
  let by = select(0u, a, exchange);
  let block = restrip_element(RESTRIP_SPLIT_FIRST, k) + (arc - 1u) * restrip_element(RESTRIP_SPLIT_CELLS, k);
  let key = restrip_key(fan, restrip_turned(loop_edges, by, k), restrip_turned(ports, by, k));
  let cell = restrip_element(RESTRIP_SPLIT_RULES, block + key);
  let ring = restrip_turned(cell & restrip_low(k + 2u), select(0u, arc + 1u, exchange), k + 2u);
  return restrip_rule(ring | (cell & (1u << (k + 2u))), loop_edges, 2);
}

fn restrip_collapse(k: u32, a: u32, inner: u32, ports: u32) -> RestripRule {
  let ring = RestripPatch(k, 0u, a + 1u);
  if (k < 3u || k > RESTRIP_MAX_K || a < 1u || a >= k) {
    return restrip_no_rule();
  }
  if (!restrip_valid(ring, inner, ports)) {
    return restrip_no_rule();
  }
  let cell = restrip_element(RESTRIP_COLLAPSE_FIRST, k) + restrip_key(ring, inner, ports);
  return restrip_rule(restrip_element(RESTRIP_COLLAPSE_RULES, cell), inner, -2);
}

fn restrip_flip(inner: u32, ports: u32) -> RestripFlipRule {
  if (inner > 1u || ports > 15u) {
    return RestripFlipRule(0u, 0u, 0, false);
  }
  let entry = restrip_element(RESTRIP_FLIP_RULES, (inner << 4u) | ports);  // the new inner edge above the ports kept
  if (entry == 255u) {
    return RestripFlipRule(0u, 0u, 0, false);
  }
  let strips = i32(countOneBits(inner)) + i32(countOneBits(ports)) - i32(countOneBits(entry));
  return RestripFlipRule(entry >> 4u, entry & 15u, strips, true);
}
