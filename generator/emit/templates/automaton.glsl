// restrip's rules for fans of any valence up to @max_k@: the look-up in an automaton, @bytes@ bytes of data.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 The restrip authors
// Written by `restrip-generate automaton --language glsl`. Do not edit: change the generator.
//
@operations@
//
// Each function takes the key of a patch (restrip's docs/reference/notation.md, "Key") and returns best colours after the operation:
// sound whatever lies outside the patch, with the fewest strips, and of those the fewest isolated triangles. Masks have bit
// 0 the lowest, 1 = solid, 0 = dashed; docs/reference/notation.md says which bit is which edge. Each takes two table reads
// for a triangle.
//
// The data are in restrip_automaton.bin, written by the same command: @words@ words of 32 bits, little-endian, to be
// copied into a storage buffer as they are. If restrip_words_in_automaton[0] is not RESTRIP_CHECKSUM_IN_AUTOMATON, file and
// data do not belong together.
//
// Bad input: any masks are safe. Bits at k and above, and bits of `joined` without a solid port, are ignored. For
// positions that are not listed above, the answer's colours are 0 and `valid` is false.
//
// It is for GLSL 4.30 or GLSL ES 3.10 and later. Declare before it, with whatever binding you like:
//     layout(std430, set = 0, binding = 0) readonly buffer RestripAutomaton { uint restrip_words_in_automaton[]; };

const uint RESTRIP_AUTOMATON_MAX_K = @max_k@u;  // whose colours fit a word
const uint RESTRIP_CHECKSUM_IN_AUTOMATON = @checksum@u;
// Where the arrays of restrip's tables/include/restrip/tables/automaton_format.hpp begin, and the bits of an element. Of
// `before` each number is two words, the word of the low cases first, and `next` holds 0 where a letter is not allowed.
const uint RESTRIP_LETTERS = 4u;
const uint RESTRIP_SECONDS = @seconds@u;
@arrays@

// `joined`: bit i is set when port i is joined, before the operation, to the solid port before it.
struct RestripKey {
  uint ports;
  uint joined;
};

// The inner edges after the operation. The number of strips grows by the triangles added, less the solid edges added.
struct RestripRecoloring {
  uint colors;
  bool valid;
};

uint restrip_automaton_element(uvec2 place, uint index) {
  uint bit = index * place.y;
  return (restrip_words_in_automaton[place.x + bit / 32u] >> (bit % 32u)) & (0xffffffffu >> (32u - place.y));
}

uint restrip_low_bits(uint n) { return (1u << n) - 1u; }

// With exactly two solid ports in a closed fan either bit of `joined` stands for the pair, from both sides. In an open
// fan nothing lies before the first solid port.
RestripKey restrip_key_in_fan(uint k, RestripKey key, bool is_closed) {
  uint ports = key.ports & restrip_low_bits(k);
  uint joined = key.joined & (is_closed ? ports : ports & (ports - 1u));
  bool pair = is_closed && joined != 0u && bitCount(ports) == 2;
  return RestripKey(ports, pair ? ports : joined);
}

uint restrip_letter(RestripKey key, uint i) {
  return ((key.ports >> i) & 1u) + ((key.joined >> i) & 1u);
}

// An arc: its class, and the entries of its letters.
struct RestripArc {
  uint arc_class;
  uint size;
  uint entries[RESTRIP_AUTOMATON_MAX_K + 1u];
};

void restrip_read(inout RestripArc arc, uint letter) {
  uint entry = RESTRIP_LETTERS * arc.arc_class + letter;
  arc.entries[arc.size] = entry;
  ++arc.size;
  arc.arc_class = restrip_automaton_element(RESTRIP_NEXT_IN_AUTOMATON, entry);
}

void restrip_read_fan(inout RestripArc arc, RestripKey key, uint from, uint to) {
  for (uint i = from; i < to; ++i) restrip_read(arc, restrip_letter(key, i));
}

RestripArc restrip_empty_arc() {
  RestripArc arc;
  arc.arc_class = 0u;
  arc.size = 0u;
  return arc;
}

// The links of an arc, bit m the link after m letters, from the case of the whole arc.
uint restrip_links(RestripArc arc, uint end) {
  uint links = 0u;
  for (uint m = arc.size; m > 0u; --m) {
    links |= uint((end & 3u) != 0u) << m;
    uint cases = restrip_automaton_element(RESTRIP_BEFORE_IN_AUTOMATON, 2u * arc.entries[m - 1u] + (end >> 3u));
    end = (cases >> (4u * (end & 7u))) & 15u;
  }
  return links | uint((end & 3u) != 0u);
}

// The links of an arc that goes over the boundary of an open fan after `above` triangles, as edges of the path that
// begins after the boundary; the first link is edge `from`. The boundary has no edges.
uint restrip_links_around(RestripArc arc, uint end, uint above, uint from) {
  uint links = restrip_links(arc, end);
  return ((links & restrip_low_bits(above)) << from) | (links >> (above + 2u));
}

// How an arc between A and D and one between D and A meet: their cases, and the chord.
uint restrip_meeting(RestripArc one, RestripArc other) {
  uint place = RESTRIP_SECONDS * restrip_automaton_element(RESTRIP_FIRST_IN_AUTOMATON, one.arc_class) +
               restrip_automaton_element(RESTRIP_SECOND_IN_AUTOMATON, other.arc_class);
  return restrip_automaton_element(RESTRIP_MEETINGS_IN_AUTOMATON,
                                   restrip_automaton_element(RESTRIP_MEET_IN_AUTOMATON, place));
}

uint restrip_closing(RestripArc arc) { return restrip_automaton_element(RESTRIP_CLOSED_IN_AUTOMATON, arc.arc_class); }

RestripRecoloring restrip_best_split(uint k, uint a, RestripKey key) {
  if (k < 3u || k > RESTRIP_AUTOMATON_MAX_K || a < 1u || a >= k) return RestripRecoloring(0u, false);
  RestripKey fan = restrip_key_in_fan(k, key, true);
  RestripArc one = restrip_empty_arc();
  RestripArc other = restrip_empty_arc();
  restrip_read_fan(one, fan, 0u, a);
  restrip_read_fan(other, fan, a, k);
  uint meeting = restrip_meeting(one, other);
  uint others = restrip_links(other, (meeting >> 4u) & 15u) << (a + 1u);
  return RestripRecoloring(restrip_links(one, meeting & 15u) | others | ((meeting >> 8u) << (k + 2u)), true);
}

RestripRecoloring restrip_best_collapse(uint k, RestripKey key) {
  if (k < 3u || k > RESTRIP_AUTOMATON_MAX_K) return RestripRecoloring(0u, false);
  RestripArc whole = restrip_empty_arc();
  restrip_read_fan(whole, restrip_key_in_fan(k, key, true), 0u, k);
  return RestripRecoloring(restrip_links(whole, restrip_closing(whole)) >> 1u, true);  // the first link is the last
}

RestripRecoloring restrip_best_open_split(uint k, uint i, uint j, RestripKey key) {
  if (k < 1u || k > RESTRIP_AUTOMATON_MAX_K || i >= j || j > k) return RestripRecoloring(0u, false);
  RestripKey fan = restrip_key_in_fan(k, key, false);
  RestripArc one = restrip_empty_arc();
  RestripArc other = restrip_empty_arc();
  restrip_read_fan(one, fan, i, j);
  restrip_read_fan(other, fan, j, k);
  restrip_read(other, RESTRIP_LETTERS - 1u);
  restrip_read_fan(other, fan, 0u, i);
  uint meeting = restrip_meeting(one, other);
  uint around = restrip_links_around(other, (meeting >> 4u) & 15u, k - j, j + 1u);
  return RestripRecoloring((restrip_links(one, meeting & 15u) << i) | around | ((meeting >> 8u) << (k + 1u)), true);
}

RestripRecoloring restrip_best_boundary_split(uint k, uint i, RestripKey key) {
  if (k < 1u || k > RESTRIP_AUTOMATON_MAX_K || i > k) return RestripRecoloring(0u, false);
  RestripKey fan = restrip_key_in_fan(k, key, false);
  RestripArc arc = restrip_empty_arc();
  restrip_read_fan(arc, fan, 0u, i);
  restrip_read(arc, 0u);  // A is a triangle without a port
  restrip_read_fan(arc, fan, i, k);
  return RestripRecoloring(restrip_links(arc, 0u) >> 1u, true);
}

RestripRecoloring restrip_best_fan_collapse(uint k, RestripKey key) {
  if (k < 1u || k > RESTRIP_AUTOMATON_MAX_K) return RestripRecoloring(0u, false);
  RestripArc arc = restrip_empty_arc();
  restrip_read_fan(arc, restrip_key_in_fan(k, key, false), 0u, k);
  return RestripRecoloring(restrip_links(arc, 0u) >> 1u, true);
}
