//! @about@
//! Written by `restrip-generate rules --language rust` from the operation file of @title@. Do not edit.
//! The look-up: SPDX-License-Identifier: MIT, Copyright (c) 2026 The restrip authors
//!
//! `rule` takes the colours of the patch before the operation and returns the best ones after it. Colours are masks, bit 0
//! the lowest, 1 = solid, 0 = dashed: of the inner edges and of the ports, numbered as restrip's docs/reference/operation-file.md
//! says. It takes constant time.
@note@
//!
//! Put this file next to yours and write `mod restrip_rule_of_@name@;`. It needs nothing but `core`, allocates nothing and has no
//! `unsafe`. The function is `const`.
//!
//! Bad input: the answer is `None` for colours that are not valid, bits outside the patch, and positions that the table
//! does not hold.
#![cfg_attr(rustfmt, rustfmt_skip)]
#![allow(dead_code)] // a program need not read every member
#![allow(clippy::unreadable_literal)]

/// The inner edges after the operation, the ports that stay solid, and the change in the number of strips.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Rule {
    pub colors: u32,
    pub ports: u32,
    pub strips: i32,
}

/// The rule of a configuration.
pub const fn rule(@parameters@inner: u32, ports: u32) -> Option<Rule> {
@position@
    let edges = EDGES[place] as u32;
    let port_count = PORTS[place] as u32;
    if port_count == 0 || inner >> edges != 0 || ports >> port_count != 0 {
        return None;
    }
    let entry = ENTRIES[FIRST[place] as usize + @configuration@ as usize] as u32;
    if entry == @none@ {
        return None;
    }
    let before = BEFORE[place] as i32 - inner.count_ones() as i32 - ports.count_ones() as i32;
    let after = AFTER[place] as i32 - entry.count_ones() as i32;
    Some(Rule { colors: entry >> port_count, ports: entry & ((1 << port_count) - 1), strips: after - before })
}

// For each position its inner edges and ports before the operation, its triangles before and after, and where its entries
// begin. A place without ports is not a position. An entry has the inner edges after above the ports that stay solid.
@arrays@
