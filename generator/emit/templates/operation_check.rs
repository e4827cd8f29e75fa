//! Prints what restrip_rule_of_@name@.rs answers to every configuration, for
//!     restrip-verify --operation FILE --header HEADER --dump-command PROGRAM
//! Written by `restrip-generate rules --language rust`. Do not edit.
#![allow(unused_variables)] // the numbers of the only position
use std::fmt::Write;

mod restrip_rule_of_@name@;

const POSITIONS: &[(&str, u32, u32, [u32; 3])] = &[
@positions@
];

fn main() {
    let mut text = String::from("restrip-table-dump 4\n");
    let mut lines = 0;
    for &(table, edge_count, port_count, at) in POSITIONS {
        writeln!(text, "table {table}").unwrap();
        for inner in 0..1 << edge_count {
            for ports in 0..1 << port_count {
                match restrip_rule_of_@name@::rule(@arguments@inner, ports) {
                    Some(r) => writeln!(text, "{inner:x} {ports:x} {:x} {:x} {}", r.colors, r.ports, r.strips),
                    None => writeln!(text, "{inner:x} {ports:x} -"),
                }
                .unwrap();
                lines += 1;
            }
        }
    }
    print!("{text}end {lines}\n");
}
