//! Asks restrip_tables.rs everything, and prints digests of what it answers, as `restrip-dump-tables --digests` does.
//!   rustc -O restrip_tables_check.rs && ./restrip_tables_check [K]
//! A line for each operation, 0, 1 and 6, and position: "operation k p q digest". The position of a split or collapse is
//! p = a; unused ones are 0.
mod restrip_tables;
use restrip_tables::*;

// A rule looked up by the compiler: a strip that passes a fan of three triangles continues over both new ones.
const _: () = assert!(matches!(split(3, 1, 0b011, 0b101), Some(Rule { strips: 0, .. })));

fn packed(colors: u32, strips: i32) -> u32 {
    0x8000_0000 | ((strips + 8) as u32) << 16 | colors
}

fn answer(operation: u32, [k, p]: [u32; 2], before: u32, ports: u32) -> u32 {
    let rule = match operation {
        0 => split(k, p, before, ports),
        1 => collapse(k, p, before, ports),
        _ => return flip(before, ports).map_or(0, |rule| packed(rule.inner << 4 | rule.ports, rule.strips)),
    };
    rule.map_or(0, |rule| packed(rule.colors, rule.strips))
}

fn inside([k, p]: [u32; 2]) -> bool {
    k >= 3 && k <= MAX_K && p >= 1 && p < k
}

fn mix(before: u32, ports: u32, answered: u32) -> u32 {
    let h = answered ^ before.wrapping_mul(0x9e37_79b1) ^ ports.wrapping_mul(0x85eb_ca77);
    let h = (h ^ h >> 16).wrapping_mul(0x85eb_ca6b);
    let h = (h ^ h >> 13).wrapping_mul(0xc2b2_ae35);
    h ^ h >> 16
}

fn line(operation: u32, at: [u32; 2], before_bits: u32, port_bits: u32) {
    let mut digest = 0u32;
    for before in 0..1 << before_bits {
        for ports in 0..1 << port_bits {
            digest = digest.wrapping_add(mix(before, ports, answer(operation, at, before, ports)));
        }
    }
    println!("{} {} {} 0 {:08x}", operation, at[0], at[1], digest);
}

fn main() {
    let max_k: u32 = std::env::args().nth(1).map_or(MAX_K, |word| word.parse().expect("K"));
    let mut outside = 0;
    for operation in 0..2 {
        for k in 0..20 {
            for p in 0..20 {
                if !inside([k, p]) {
                    outside += u32::from(answer(operation, [k, p], 0, 0) != 0);
                } else if k <= max_k {
                    line(operation, [k, p], k + 3 * operation, k);
                }
            }
        }
    }
    line(6, [0, 0], 1, 4);
    outside += u32::from(answer(6, [0, 0], 2, 0) != 0 || answer(6, [0, 0], 0, 16) != 0);
    println!("rules outside the tables: {}", outside);
}
