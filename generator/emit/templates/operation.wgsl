// @about@
// Written by `restrip-generate rules --language wgsl` from the operation file of @title@. Do not edit.
// The look-up: SPDX-License-Identifier: MIT, Copyright (c) 2026 The restrip authors
//
// restrip_rule_of_@name@ takes the colours of the patch before the operation and returns the best ones after it. Colours
// are masks, bit 0 the lowest, 1 = solid, 0 = dashed: of the inner edges and of the ports, numbered as restrip's
// docs/reference/operation-file.md says. It takes constant time.
@note@
//
// The data are in restrip_rule_of_@name@.bin, written by the same command: @words@ words of 32 bits, little-endian, to be copied
// into a storage buffer as they are. If the first word is not RESTRIP_CHECKSUM_OF_@capitals@, file and data do not belong
// together.
//
// Bad input: for colours that are not valid, bits outside the patch, and positions that the table does not hold, every
// member of the answer is 0 and `valid` is false.
//
// Declare in the same module, with whatever binding you like:
//     @group(0) @binding(0) var<storage, read> restrip_words_of_@name@: array<u32>;

const RESTRIP_CHECKSUM_OF_@capitals@ = @checksum@u;

// For each position its inner edges and ports before the operation, its triangles before and after, and where its entries
// begin: the word with which the array begins, and how many bits an element has. A place without ports is not a position. An
// entry has the inner edges after above the ports that stay solid.
@arrays@

// The inner edges after the operation, the ports that stay solid, and the change in the number of strips.
struct restrip_answer_of_@name@ {
  colors: u32,
  ports: u32,
  strips: i32,
  valid: bool,
}

fn restrip_element_of_@name@(place: vec2<u32>, index: u32) -> u32 {
  let bit = index * place.y;
  return (restrip_words_of_@name@[place.x + bit / 32u] >> (bit % 32u)) & (0xffffffffu >> (32u - place.y));
}

fn restrip_rule_of_@name@(@parameters@inner: u32, ports: u32) -> restrip_answer_of_@name@ {
  let none = restrip_answer_of_@name@(0u, 0u, 0, false);
  var place = 0u;
@position@
  let edges = restrip_element_of_@name@(RESTRIP_EDGES_OF_@capitals@, place);
  let port_count = restrip_element_of_@name@(RESTRIP_PORTS_OF_@capitals@, place);
  if (port_count == 0u || (inner >> edges) != 0u || (ports >> port_count) != 0u) {
    return none;
  }
  let first = restrip_element_of_@name@(RESTRIP_FIRST_OF_@capitals@, place);
  let entry = restrip_element_of_@name@(RESTRIP_ENTRIES_OF_@capitals@, first + @configuration@);
  if (entry == @none@u) {
    return none;
  }
  let before = i32(restrip_element_of_@name@(RESTRIP_BEFORE_OF_@capitals@, place) - countOneBits(inner) - countOneBits(ports));
  let after = i32(restrip_element_of_@name@(RESTRIP_AFTER_OF_@capitals@, place) - countOneBits(entry));
  return restrip_answer_of_@name@(entry >> port_count, entry & ((1u << port_count) - 1u), after - before, true);
}
