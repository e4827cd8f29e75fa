//! restrip's rule tables up to k = @max_k@: @bytes@ bytes of data, and the look-up.
//! SPDX-License-Identifier: MIT
//! Copyright (c) 2026 The restrip authors
//! Written by `restrip-generate tables --language rust --max-k @max_k@`. Do not edit: change the generator.
//!
@operations@
//!
//! Each function takes the colours of a patch before an operation and returns the best colours after it: sound
//! whatever lies outside the patch, with the fewest strips, and of those with the fewest isolated triangles. Colours
//! are masks, bit 0 the lowest, 1 = solid, 0 = dashed; restrip's docs/reference/notation.md says which bit is which edge. Each
//! takes O(k) steps.
//!
//! Put this file next to yours and write `mod restrip_tables;`. It needs nothing but `core`, allocates nothing and has no
//! `unsafe`. The functions are `const`.
//!
//! Bad input: the answer is `None` for colours that no valid stripification has (three solid edges at a triangle, a solid
//! cycle, bits outside the patch), and for positions that the tables do not hold (`k > MAX_K`, a out of range).
#![cfg_attr(rustfmt, rustfmt_skip)]
#![allow(dead_code)] // a program need not use every operation
#![allow(clippy::unreadable_literal)]

/// The inner edges after an operation, and the change in the number of strips.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Rule {
    pub colors: u32,
    pub strips: i32,
}

/// The inner edge after a flip, the ports that stay solid (a flip may have to give some up), and the change in the number
/// of strips.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FlipRule {
    pub inner: u32,
    pub ports: u32,
    pub strips: i32,
}

/// Split of a closed fan.
pub const fn split(k: u32, a: u32, loop_edges: u32, ports: u32) -> Option<Rule> {
    let fan = Patch { k, a: NOWHERE, d: NOWHERE };
    if k < 3 || k > MAX_K || a < 1 || a >= k || !fan.valid(loop_edges, ports) {
        return None;
    }
    // The tables have the positions whose first arc is the shorter one. In the others A and D change places, and the fan
    // is turned until it begins with the second arc.
    let (arc, by) = if 2 * a > k { (k - a, a) } else { (a, 0) };
    let place = key(fan, turned(loop_edges, by, k), turned(ports, by, k));
    let start = SPLIT_FIRST[k as usize] as u32 + (arc - 1) * SPLIT_CELLS[k as usize] as u32;
    let cell = SPLIT_RULES[(start + place) as usize] as u32;
    let ring = turned(cell & low(k + 2), if by != 0 { arc + 1 } else { 0 }, k + 2);
    rule(ring | (cell & 1 << (k + 2)), loop_edges, 2)
}

/// Collapse onto a closed fan.
pub const fn collapse(k: u32, a: u32, inner: u32, ports: u32) -> Option<Rule> {
    if k < 3 || k > MAX_K || a < 1 || a >= k {
        return None;
    }
    let ring = Patch { k, a: 0, d: a + 1 };
    if !ring.valid(inner, ports) {
        return None;
    }
    let cell = COLLAPSE_FIRST[k as usize] as u32 + key(ring, inner, ports);
    rule(COLLAPSE_RULES[cell as usize] as u32, inner, -2)
}

/// Flip of the edge between two triangles.
pub const fn flip(inner: u32, ports: u32) -> Option<FlipRule> {
    if inner > 1 || ports > 15 {
        return None;
    }
    let entry = FLIP_RULES[(inner << 4 | ports) as usize] as u32; // the new inner edge above the ports kept
    if entry == 255 {
        return None;
    }
    let strips = inner.count_ones() as i32 + ports.count_ones() as i32 - entry.count_ones() as i32;
    Some(FlipRule { inner: entry >> 4, ports: entry & 15, strips })
}

/// The patch before an operation as a ring of elements: the k triangles of the fan in order, with A at element `a` and D at
/// element `d`, or NOWHERE. Inner edge m joins elements m and m + 1, the last one the last element and the first. The
/// chord A - D has the bit after the edges.
#[derive(Clone, Copy)]
struct Patch {
    k: u32,
    a: u32,
    d: u32,
}

const NOWHERE: u32 = 31;

const fn low(n: u32) -> u32 {
    (1 << n) - 1
}

const fn has(mask: u32, i: u32) -> bool {
    mask >> i & 1 != 0
}

/// Turns a ring of n bits so that bit `by` becomes bit 0.
const fn turned(mask: u32, by: u32, n: u32) -> u32 {
    (mask >> by | mask << (n - by)) & low(n)
}

const fn insert_zero(mask: u32, at: u32) -> u32 {
    (mask & low(at)) | (mask & !low(at)) << 1
}

const fn remove_bit(mask: u32, at: u32) -> u32 {
    (mask & low(at)) | (mask >> 1 & !low(at))
}

impl Patch {
    const fn size(self) -> u32 {
        self.k + (self.a != NOWHERE) as u32 + (self.d != NOWHERE) as u32
    }

    const fn has_chord(self, inner: u32) -> bool {
        self.d != NOWHERE && has(inner, self.size())
    }

    /// Ports as a mask over elements.
    const fn spread(self, ports: u32) -> u32 {
        insert_zero(insert_zero(ports, self.a), self.d)
    }

    /// At most two solid edges at every element, no solid cycle, no bit outside the patch.
    const fn valid(self, inner: u32, ports: u32) -> bool {
        let all = low(self.size());
        let edges = inner & all;
        let below = edges << 1 | edges >> (self.size() - 1);
        let between = low(self.d) & !low(self.a); // with a chord: the edges from A up to D
        let chord = self.has_chord(inner);
        let ends = if chord { 1 << self.a | 1 << self.d } else { 0 };
        if inner >> self.size() > chord as u32 || ports >> self.k != 0 {
            return false;
        }
        if edges & below & (self.spread(ports) | ends) != 0 || edges == all {
            return false;
        }
        !chord || (!edges & between != 0 && !edges & all & !between != 0)
    }

    /// The element at which the strand from element `at` ends, which has exactly one solid edge among `edges`.
    const fn strand_end(self, edges: u32, at: u32) -> u32 {
        if has(edges, at) {
            return at + (edges >> at).trailing_ones();
        }
        let at = if at == 0 { self.size() } else { at }; // downwards from the first element
        at - (edges << (32 - at)).leading_ones()
    }

    /// The pair of ports (by element) that a path over the chord joins, as the bit that names it in a key: the bit of the
    /// port that comes after the other, with no solid port between them. 0 if no such pair exists.
    const fn joined_by_chord(self, edges: u32, ports: u32) -> u32 {
        let below_a = if self.a > 0 { self.a - 1 } else { self.size() - 1 };
        let a_goes_on = has(edges, below_a) != has(edges, self.a);
        let d_goes_on = has(edges, self.d - 1) != has(edges, self.d);
        if !a_goes_on || !d_goes_on {
            return 0;
        }
        let one = self.strand_end(edges, self.a);
        let two = self.strand_end(edges, self.d);
        if !has(ports, one) || !has(ports, two) {
            return 0;
        }
        let (first, last) = if one < two { (one, two) } else { (two, one) };
        let within = low(last + 1) & !low(first);
        if (ports & within).count_ones() == 2 {
            1 << last
        } else if ports & !within == 0 {
            1 << first
        } else {
            0
        }
    }

    /// Bit i is set when port i is solid and a solid path inside leads to the solid port before it. Adding the solid ports
    /// at which a strand begins upwards to the edges sends a carry through each run of solid edges, to the element where
    /// it ends. With exactly two solid ports each comes before the other: either bit stands for the pair.
    const fn joined(self, inner: u32, fan_ports: u32) -> u32 {
        let ports = self.spread(fan_ports);
        let edges = inner & low(self.size());
        let carried = edges + (ports & edges);
        let ends = (carried & low(self.size())) + (carried >> self.size()); // the carry goes round
        let mut joined = ends & !edges & ports;
        if self.has_chord(inner) {
            joined |= self.joined_by_chord(edges, ports);
        }
        remove_bit(remove_bit(joined, self.d), self.a)
    }
}

const fn rule(colors: u32, before: u32, new_triangles: i32) -> Option<Rule> {
    Some(Rule { colors, strips: new_triangles - colors.count_ones() as i32 + before.count_ones() as i32 })
}

// The rules of an operation depend on its position and on the key (ports, joined). The cell of a key is
//     RULES[FIRST[k] + place * CELLS[k] + ROWS[1 << k | ports] + joined]
// with one packing for all rules.

/// The place of a key in the block of its valence and position.
const fn key(patch: Patch, inner: u32, ports: u32) -> u32 {
    CLOSED_ROWS[(1 << patch.k | ports) as usize] as u32 + patch.joined(inner, ports)
}

/// The largest valence that the tables answer.
pub const MAX_K: u32 = @max_k@;
@arrays@
