/* The emitted look-ups of a single operation, of a matching and of a family: all colours with a bit too many, positions
   beside those that there are. Prints digests of the answers. */
#include <stdio.h>

#define RESTRIP_BISECT_IMPLEMENTATION
#include "restrip_bisect.h"
#define RESTRIP_BISECT_MATCHING_IMPLEMENTATION
#include "restrip_bisect_matching.h"
#define RESTRIP_CORNER_TURNS_IMPLEMENTATION
#include "restrip_corner_turns.h"

static uint32_t digest;

static void tell(restrip_operation_rule rule) {
  digest = digest * UINT32_C(1000003) + rule.colors;
  digest = digest * UINT32_C(1000003) + rule.ports;
  digest = digest * UINT32_C(1000003) + (uint32_t)rule.strips;
  digest = digest * UINT32_C(1000003) + rule.valid;
}

int main(void) {
  uint32_t inner, ports, k, i;
  for (inner = 0; inner < 8; ++inner)
    for (ports = 0; ports < 64; ++ports) {
      tell(restrip_rule_of_bisect(inner, ports));
      tell(restrip_rule_of_bisect_matching(inner, ports));
    }
  printf("single %08x\n", (unsigned)digest);
  for (k = 0; k < 7; ++k) {
    digest = 0;
    for (i = 0; i < 7; ++i)
      for (inner = 0; inner < 64; ++inner)
        for (ports = 0; ports < 64; ++ports) tell(restrip_rule_of_corner_turns(k, i, inner, ports));
    printf("corner-turns %u %08x\n", (unsigned)k, (unsigned)digest);
  }
  return 0;
}
