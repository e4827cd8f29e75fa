//! Asks restrip_automaton.rs, and prints digests of what it answers, as `restrip-dump-tables --automaton --digests` does.
//!   rustc -O restrip_automaton_check.rs && ./restrip_automaton_check [K]
//! A line for each operation, 0 split, 1 collapse, 2 open split, 3 fan collapse and 4 boundary split, and each position with
//! k <= K, by default 28: "operation k p q digest". Where a position has at most 7,000 keys all are asked, else 64 that are
//! drawn.
mod restrip_automaton;
use restrip_automaton::*;

// A rule looked up by the compiler: a fan of one triangle has no edge inside.
const _: () = assert!(matches!(best_fan_collapse(1, Key { ports: 1, joined: 0 }), Some(0)));

fn mix(before: u32, ports: u32, answered: u32) -> u32 {
    let h = answered ^ before.wrapping_mul(0x9e37_79b1) ^ ports.wrapping_mul(0x85eb_ca77);
    let h = (h ^ h >> 16).wrapping_mul(0x85eb_ca6b);
    let h = (h ^ h >> 13).wrapping_mul(0xc2b2_ae35);
    h ^ h >> 16
}

/// How many keys are asked for a fan of k triangles.
fn keys_of(k: u32) -> u32 {
    let keys = 3u64.saturating_pow(k);
    if keys <= 7000 { keys as u32 } else { 64 }
}

/// Key n: a letter for each port, the last one the lowest digit; or masks that are drawn.
fn key_numbered(k: u32, mut n: u32, keys: u32) -> Key {
    if keys == 64 {
        let drawn = |i| (u64::from(mix(n, i, 0)) | u64::from(mix(n, i + 8, 0)) << 32) & ((1 << k) - 1);
        return Key { ports: drawn(0), joined: drawn(1) };
    }
    let mut key = Key::default();
    for i in (0..k).rev() {
        let letter = n % 3;
        n /= 3;
        key.ports |= u64::from(letter != 0) << i;
        key.joined |= u64::from(letter == 2) << i;
    }
    key
}

fn answer(operation: u32, [k, p, q]: [u32; 3], key: Key) -> Option<u64> {
    match operation {
        0 => best_split(k, p, key),
        1 => best_collapse(k, key),
        2 => best_open_split(k, p, q, key),
        3 => best_fan_collapse(k, key),
        _ => best_boundary_split(k, p, key),
    }
}

fn inside(operation: u32, [k, p, q]: [u32; 3], max_k: u32) -> bool {
    (if operation < 2 { 3 } else { 1 }..=max_k).contains(&k)
        && match operation {
            0 => p >= 1 && p < k,
            2 => p < q && q <= k,
            _ => p <= k,
        }
}

fn folded(mask: u64) -> u32 {
    mask as u32 ^ ((mask >> 32) as u32).wrapping_mul(0x9e37_79b1)
}

fn main() {
    let max_k: u32 = std::env::args().nth(1).map_or(28, |word| word.parse().expect("K"));
    let mut outside = 0;
    for operation in 0..5 {
        for k in 0..70 {
            for p in 0..if operation % 2 == 1 { 1 } else { 70 } {
                for q in 0..if operation == 2 { 70 } else { 1 } {
                    let at = [k, p, q];
                    if !inside(operation, at, MAX_K) {
                        outside += u32::from(answer(operation, at, Key::default()).is_some());
                    } else if k <= max_k {
                        let (mut digest, keys) = (0u32, keys_of(k));
                        for n in 0..keys {
                            let key = key_numbered(k, n, keys);
                            let made = answer(operation, at, key).map_or(0, |colors| 0x8000_0000 | folded(colors));
                            digest = digest.wrapping_add(mix(n, folded(key.ports), made));
                        }
                        println!("{} {} {} {} {:08x}", operation, k, p, q, digest);
                    }
                }
            }
        }
    }
    println!("rules outside the tables: {}", outside);
}
