// @about@
// Written by `restrip-generate rules --language glsl` from the operation file of @title@. Do not edit.
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
// It is for GLSL 4.30 or GLSL ES 3.10 and later. Declare before it, with whatever binding and names of the block you like:
//     layout(std430, set = 0, binding = 0) readonly buffer RestripTable { uint restrip_words_of_@name@[]; };

const uint RESTRIP_CHECKSUM_OF_@capitals@ = @checksum@u;

// For each position its inner edges and ports before the operation, its triangles before and after, and where its entries
// begin: the word with which the array begins, and how many bits an element has. A place without ports is not a position. An
// entry has the inner edges after above the ports that stay solid.
@arrays@

// The inner edges after the operation, the ports that stay solid, and the change in the number of strips.
struct restrip_answer_of_@name@ {
  uint colors;
  uint ports;
  int strips;
  bool valid;
};

uint restrip_element_of_@name@(uvec2 where, uint index) {
  uint bit = index * where.y;
  return (restrip_words_of_@name@[where.x + bit / 32u] >> (bit % 32u)) & (0xffffffffu >> (32u - where.y));
}

restrip_answer_of_@name@ restrip_rule_of_@name@(@parameters@uint inner, uint ports) {
  restrip_answer_of_@name@ none = restrip_answer_of_@name@(0u, 0u, 0, false);
  uint place = 0u;
@position@
  uint edges = restrip_element_of_@name@(RESTRIP_EDGES_OF_@capitals@, place);
  uint port_count = restrip_element_of_@name@(RESTRIP_PORTS_OF_@capitals@, place);
  if (port_count == 0u || (inner >> edges) != 0u || (ports >> port_count) != 0u) return none;
  uint first = restrip_element_of_@name@(RESTRIP_FIRST_OF_@capitals@, place);
  uint entry = restrip_element_of_@name@(RESTRIP_ENTRIES_OF_@capitals@, first + @configuration@);
  if (entry == @none@u) return none;
  int before = int(restrip_element_of_@name@(RESTRIP_BEFORE_OF_@capitals@, place)) - bitCount(inner) - bitCount(ports);
  int after = int(restrip_element_of_@name@(RESTRIP_AFTER_OF_@capitals@, place)) - bitCount(entry);
  return restrip_answer_of_@name@(entry >> port_count, entry & ((1u << port_count) - 1u), after - before, true);
}
