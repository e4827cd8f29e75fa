// @about@
// Written by `restrip-generate rules --language c` from the operation file of @title@. Do not edit.
// The look-up: SPDX-License-Identifier: MIT, Copyright (c) 2026 The restrip authors
//
// restrip_rule_of_@name@ takes the colours of the patch before the operation and returns the best ones after it. Colours
// are masks, bit 0 the lowest, 1 = solid, 0 = dashed: of the inner edges and of the ports, numbered as restrip's
// docs/reference/operation-file.md says. It takes constant time.
@note@
//
// Include this file wherever you need the declaration. In exactly one source file write
//     #define RESTRIP_RULE_OF_@capitals@_IMPLEMENTATION
// before the include: there are the data and the body. Nothing is allocated, no library is called, nothing is written.
//
// Bad input: for colours that are not valid, bits outside the patch, and positions that the table does not hold, every
// member of the answer is 0 and `valid` is false.
#ifndef RESTRIP_RULE_OF_@capitals@_H
#define RESTRIP_RULE_OF_@capitals@_H

#include <stdbool.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#ifndef RESTRIP_OPERATION_RULE
#define RESTRIP_OPERATION_RULE
// The inner edges after the operation, the ports that stay solid, and the change in the number of strips.
typedef struct restrip_operation_rule {
  uint32_t colors;
  uint32_t ports;
  int32_t strips;
  bool valid;
} restrip_operation_rule;
#endif

restrip_operation_rule restrip_rule_of_@name@(@parameters@uint32_t inner, uint32_t ports);

#ifdef __cplusplus
}
#endif

#endif  // RESTRIP_RULE_OF_@capitals@_H

#ifdef RESTRIP_RULE_OF_@capitals@_IMPLEMENTATION
#undef RESTRIP_RULE_OF_@capitals@_IMPLEMENTATION

// For each position its inner edges and ports before the operation, its triangles before and after, and where its entries
// begin. A place without ports is not a position. An entry has the inner edges after above the ports that stay solid.
@arrays@

static int32_t restrip_count_of_@name@(uint32_t mask) {
  int32_t n = 0;
  for (; mask != 0; mask &= mask - 1) ++n;
  return n;
}

restrip_operation_rule restrip_rule_of_@name@(@parameters@uint32_t inner, uint32_t ports) {
  restrip_operation_rule rule = {0, 0, 0, false};
  uint32_t place = 0, edges, port_count, entry;
@position@
  edges = restrip_edges_of_@name@[place];
  port_count = restrip_ports_of_@name@[place];
  if (port_count == 0 || inner >> edges != 0 || ports >> port_count != 0) return rule;
  entry = restrip_entries_of_@name@[restrip_first_of_@name@[place] + @configuration@];
  if (entry == UINT32_C(@none@)) return rule;
  rule.colors = entry >> port_count;
  rule.ports = entry & ((UINT32_C(1) << port_count) - 1);
  rule.strips = restrip_after_of_@name@[place] - restrip_before_of_@name@[place] + restrip_count_of_@name@(inner) +
                restrip_count_of_@name@(ports) - restrip_count_of_@name@(entry);
  rule.valid = true;
  return rule;
}
#endif  // RESTRIP_RULE_OF_@capitals@_IMPLEMENTATION
