// restrip's rules for fans of any valence up to @max_k@: the look-up in an automaton, @bytes@ bytes of data.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 The restrip authors
// Written by `restrip-generate automaton --language wgsl`. Do not edit: change the generator.
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
// Declare in the same module, with whatever binding you like:
//     @group(0) @binding(0) var<storage, read> restrip_words_in_automaton: array<u32>;

const RESTRIP_AUTOMATON_MAX_K = @max_k@u;  // whose colours fit a word
const RESTRIP_CHECKSUM_IN_AUTOMATON = @checksum@u;
// Where the arrays of restrip's tables/include/restrip/tables/automaton_format.hpp begin, and the bits of an element. Of
// `before` each number is two words, the word of the low cases first, and `next` holds 0 where a letter is not allowed.
const RESTRIP_LETTERS = 4u;
const RESTRIP_SECONDS = @seconds@u;
@arrays@

// `joined`: bit i is set when port i is joined, before the operation, to the solid port before it.
struct RestripKey {
  ports: u32,
  joined: u32,
}

// The inner edges after the operation. The number of strips grows by the triangles added, less the solid edges added.
struct RestripRecoloring {
  colors: u32,
  valid: bool,
}

fn restrip_automaton_element(place: vec2<u32>, index: u32) -> u32 {
  let bit = index * place.y;
  return (restrip_words_in_automaton[place.x + bit / 32u] >> (bit % 32u)) & (0xffffffffu >> (32u - place.y));
}

fn restrip_low_bits(n: u32) -> u32 { return (1u << n) - 1u; }

// With exactly two solid ports in a closed fan either bit of `joined` stands for the pair, from both sides. In an open
// fan nothing lies before the first solid port.
fn restrip_key_in_fan(k: u32, key: RestripKey, is_closed: bool) -> RestripKey {
  let ports = key.ports & restrip_low_bits(k);
  let joined = key.joined & select(ports & (ports - 1u), ports, is_closed);
  let pair = is_closed && joined != 0u && countOneBits(ports) == 2u;
  return RestripKey(ports, select(joined, ports, pair));
}

fn restrip_letter(key: RestripKey, i: u32) -> u32 {
  return ((key.ports >> i) & 1u) + ((key.joined >> i) & 1u);
}

// An arc: its class, and the entries of its letters.
struct RestripArc {
  arc_class: u32,
  size: u32,
  entries: array<u32, RESTRIP_AUTOMATON_MAX_K + 1u>,
}

fn restrip_read(arc: ptr<function, RestripArc>, letter: u32) {
  let entry = RESTRIP_LETTERS * (*arc).arc_class + letter;
  (*arc).entries[(*arc).size] = entry;
  (*arc).size += 1u;
  (*arc).arc_class = restrip_automaton_element(RESTRIP_NEXT_IN_AUTOMATON, entry);
}

fn restrip_read_fan(arc: ptr<function, RestripArc>, key: RestripKey, first: u32, end: u32) {
  for (var i = first; i < end; i += 1u) {
    restrip_read(arc, restrip_letter(key, i));
  }
}

fn restrip_empty_arc() -> RestripArc { return RestripArc(); }

// The links of an arc, bit m the link after m letters, from the case of the whole arc.
fn restrip_links(arc: RestripArc, end_case: u32) -> u32 {
  var end = end_case;
  var links = 0u;
  for (var m = arc.size; m > 0u; m -= 1u) {
    links |= u32((end & 3u) != 0u) << m;
    let cases = restrip_automaton_element(RESTRIP_BEFORE_IN_AUTOMATON, 2u * arc.entries[m - 1u] + (end >> 3u));
    end = (cases >> (4u * (end & 7u))) & 15u;
  }
  return links | u32((end & 3u) != 0u);
}

// The links of an arc that goes over the boundary of an open fan after `above` triangles, as edges of the path that
// begins after the boundary; the first link is edge `first_edge`. The boundary has no edges.
fn restrip_links_around(arc: RestripArc, end: u32, above: u32, first_edge: u32) -> u32 {
  let links = restrip_links(arc, end);
  return ((links & restrip_low_bits(above)) << first_edge) | (links >> (above + 2u));
}

// How an arc between A and D and one between D and A meet: their cases, and the chord.
fn restrip_meeting(one: RestripArc, other: RestripArc) -> u32 {
  let place = RESTRIP_SECONDS * restrip_automaton_element(RESTRIP_FIRST_IN_AUTOMATON, one.arc_class) +
               restrip_automaton_element(RESTRIP_SECOND_IN_AUTOMATON, other.arc_class);
  return restrip_automaton_element(RESTRIP_MEETINGS_IN_AUTOMATON,
                                   restrip_automaton_element(RESTRIP_MEET_IN_AUTOMATON, place));
}

fn restrip_closing(arc: RestripArc) -> u32 { return restrip_automaton_element(RESTRIP_CLOSED_IN_AUTOMATON, arc.arc_class); }

fn restrip_best_split(k: u32, a: u32, key: RestripKey) -> RestripRecoloring {
  if (k < 3u || k > RESTRIP_AUTOMATON_MAX_K || a < 1u || a >= k) {
    return RestripRecoloring(0u, false);
  }
  let fan = restrip_key_in_fan(k, key, true);
  var one = restrip_empty_arc();
  var other = restrip_empty_arc();
  restrip_read_fan(&one, fan, 0u, a);
  restrip_read_fan(&other, fan, a, k);
  let meeting = restrip_meeting(one, other);
  let others = restrip_links(other, (meeting >> 4u) & 15u) << (a + 1u);
  return RestripRecoloring(restrip_links(one, meeting & 15u) | others | ((meeting >> 8u) << (k + 2u)), true);
}

fn restrip_best_collapse(k: u32, key: RestripKey) -> RestripRecoloring {
  if (k < 3u || k > RESTRIP_AUTOMATON_MAX_K) {
    return RestripRecoloring(0u, false);
  }
  var whole = restrip_empty_arc();
  restrip_read_fan(&whole, restrip_key_in_fan(k, key, true), 0u, k);
  return RestripRecoloring(restrip_links(whole, restrip_closing(whole)) >> 1u, true);  // the first link is the last
}

fn restrip_best_open_split(k: u32, i: u32, j: u32, key: RestripKey) -> RestripRecoloring {
  if (k < 1u || k > RESTRIP_AUTOMATON_MAX_K || i >= j || j > k) {
    return RestripRecoloring(0u, false);
  }
  let fan = restrip_key_in_fan(k, key, false);
  var one = restrip_empty_arc();
  var other = restrip_empty_arc();
  restrip_read_fan(&one, fan, i, j);
  restrip_read_fan(&other, fan, j, k);
  restrip_read(&other, RESTRIP_LETTERS - 1u);
  restrip_read_fan(&other, fan, 0u, i);
  let meeting = restrip_meeting(one, other);
  let around = restrip_links_around(other, (meeting >> 4u) & 15u, k - j, j + 1u);
  return RestripRecoloring((restrip_links(one, meeting & 15u) << i) | around | ((meeting >> 8u) << (k + 1u)), true);
}

fn restrip_best_boundary_split(k: u32, i: u32, key: RestripKey) -> RestripRecoloring {
  if (k < 1u || k > RESTRIP_AUTOMATON_MAX_K || i > k) {
    return RestripRecoloring(0u, false);
  }
  let fan = restrip_key_in_fan(k, key, false);
  var arc = restrip_empty_arc();
  restrip_read_fan(&arc, fan, 0u, i);
  restrip_read(&arc, 0u);  // A is a triangle without a port
  restrip_read_fan(&arc, fan, i, k);
  return RestripRecoloring(restrip_links(arc, 0u) >> 1u, true);
}

fn restrip_best_fan_collapse(k: u32, key: RestripKey) -> RestripRecoloring {
  if (k < 1u || k > RESTRIP_AUTOMATON_MAX_K) {
    return RestripRecoloring(0u, false);
  }
  var arc = restrip_empty_arc();
  restrip_read_fan(&arc, restrip_key_in_fan(k, key, false), 0u, k);
  return RestripRecoloring(restrip_links(arc, 0u) >> 1u, true);
}
