//! restrip's rules for fans of any valence up to @max_k@: an automaton, @bytes@ bytes of data, and the look-up.
//! SPDX-License-Identifier: MIT
//! Copyright (c) 2026 The restrip authors
//! Written by `restrip-generate automaton --language rust`. Do not edit: change the generator.
//!
@operations@
//!
//! Each function takes the key of a patch (restrip's docs/reference/notation.md, "Key") and returns best colours after the
//! operation: sound whatever lies outside the patch, with the fewest strips, and of those the fewest isolated triangles.
//! Masks have bit 0 the lowest, 1 = solid, 0 = dashed; docs/reference/notation.md says which bit is which edge. Each takes
//! two table reads for a triangle.
//!
//! Put this file next to yours and write `mod restrip_automaton;`. It needs nothing but `core`, allocates nothing and has no
//! `unsafe`. The functions are `const`.
//!
//! Bad input: any masks are safe. Bits at `k` and above, and bits of `joined` without a solid port, are ignored.
//! The answer is `None` for positions that are not listed above.
#![cfg_attr(rustfmt, rustfmt_skip)]
#![allow(dead_code)] // a program need not use every operation
#![allow(clippy::unreadable_literal)]

/// `joined`: bit i is set when port i is joined, before the operation, to the solid port before it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Key {
    pub ports: u64,
    pub joined: u64,
}

/// Split of a closed fan: the inner edges after it. As everywhere here, the number of strips grows by the triangles added,
/// less the solid edges added.
pub const fn best_split(k: u32, a: u32, key: Key) -> Option<u64> {
    if k < 3 || k > MAX_K || a < 1 || a >= k {
        return None;
    }
    let key = key.in_fan(k, true);
    let one = Arc::EMPTY.read_fan(key, 0, a);
    let other = Arc::EMPTY.read_fan(key, a, k);
    let meeting = one.meeting(other);
    Some(one.links(meeting & 15) | other.links(meeting >> 4 & 15) << (a + 1) | ((meeting >> 8) as u64) << (k + 2))
}

/// Collapse onto a closed fan, whatever the position: the loop.
pub const fn best_collapse(k: u32, key: Key) -> Option<u64> {
    if k < 3 || k > MAX_K {
        return None;
    }
    let whole = Arc::EMPTY.read_fan(key.in_fan(k, true), 0, k);
    Some(whole.links(CLOSED[whole.class as usize] as u32) >> 1) // the first link is the last
}

/// Split of an open fan, two triangles.
pub const fn best_open_split(k: u32, i: u32, j: u32, key: Key) -> Option<u64> {
    if k < 1 || k > MAX_K || i >= j || j > k {
        return None;
    }
    let key = key.in_fan(k, false);
    let one = Arc::EMPTY.read_fan(key, i, j);
    let other = Arc::EMPTY.read_fan(key, j, k).read(LETTERS - 1).read_fan(key, 0, i);
    let meeting = one.meeting(other);
    let around = other.links_around(meeting >> 4 & 15, k - j, j + 1);
    Some(one.links(meeting & 15) << i | around | ((meeting >> 8) as u64) << (k + 1))
}

/// Split of an open fan along its boundary, one triangle.
pub const fn best_boundary_split(k: u32, i: u32, key: Key) -> Option<u64> {
    if k < 1 || k > MAX_K || i > k {
        return None;
    }
    let key = key.in_fan(k, false);
    // A is a triangle without a port.
    Some(Arc::EMPTY.read_fan(key, 0, i).read(0).read_fan(key, i, k).links(0) >> 1)
}

/// Collapse onto an open fan, one triangle or two, whatever the position.
pub const fn best_fan_collapse(k: u32, key: Key) -> Option<u64> {
    if k < 1 || k > MAX_K {
        return None;
    }
    Some(Arc::EMPTY.read_fan(key.in_fan(k, false), 0, k).links(0) >> 1)
}

const fn low_bits(n: u32) -> u64 {
    (1 << n) - 1
}

impl Key {
    /// With exactly two solid ports in a closed fan either bit of `joined` stands for the pair, from both sides. In an
    /// open fan nothing lies before the first solid port.
    const fn in_fan(self, k: u32, closed: bool) -> Key {
        let ports = self.ports & low_bits(k);
        let but_one = ports & ports.wrapping_sub(1);
        let joined = self.joined & if closed { ports } else { but_one };
        let pair = closed && joined != 0 && ports.count_ones() == 2;
        Key { ports, joined: if pair { ports } else { joined } }
    }

    const fn letter(self, i: u32) -> u32 {
        (self.ports >> i & 1) as u32 + (self.joined >> i & 1) as u32
    }
}

/// An arc: its class, and the entries of its letters.
#[derive(Clone, Copy)]
struct Arc {
    class: u32,
    size: u32,
    entries: [u32; MAX_K as usize + 1],
}

impl Arc {
    const EMPTY: Arc = Arc { class: 0, size: 0, entries: [0; MAX_K as usize + 1] };

    const fn read(mut self, letter: u32) -> Arc {
        let entry = LETTERS * self.class + letter;
        self.entries[self.size as usize] = entry;
        self.size += 1;
        self.class = NEXT[entry as usize] as u32;
        self
    }

    const fn read_fan(mut self, key: Key, from: u32, to: u32) -> Arc {
        let mut i = from;
        while i < to {
            self = self.read(key.letter(i));
            i += 1;
        }
        self
    }

    /// The links, bit m the link after m letters, from the case of the whole arc.
    const fn links(self, end: u32) -> u64 {
        let mut end = end;
        let mut links = 0;
        let mut m = self.size;
        while m > 0 {
            links |= ((end & 3 != 0) as u64) << m;
            m -= 1;
            end = BEFORE[(2 * self.entries[m as usize] + (end >> 3)) as usize] >> (4 * (end & 7)) & 15;
        }
        links | (end & 3 != 0) as u64
    }

    /// The links of an arc that goes over the boundary of an open fan after `above` triangles, as edges of the path that
    /// begins after the boundary; the first link is edge `from`. The boundary has no edges.
    const fn links_around(self, end: u32, above: u32, from: u32) -> u64 {
        let links = self.links(end);
        (links & low_bits(above)) << from | links >> (above + 2)
    }

    /// How an arc between A and D and one between D and A meet: their cases, and the chord.
    const fn meeting(self, other: Arc) -> u32 {
        let place = SECONDS * FIRST[self.class as usize] as u32 + SECOND[other.class as usize] as u32;
        MEETINGS[MEET[place as usize] as usize] as u32
    }
}

/// The largest valence whose colours fit a word.
pub const MAX_K: u32 = @max_k@;

// The arrays of restrip's tables/include/restrip/tables/automaton_format.hpp, which explains them; but of BEFORE each
// number is two words, the word of the low cases first, and NEXT holds 0 where a letter is not allowed.
const LETTERS: u32 = 4;
const SECONDS: u32 = @seconds@;
@arrays@
