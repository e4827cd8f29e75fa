/* Prints what restrip_rule_of_@name@.h answers to every configuration, for
     restrip-verify --operation FILE --header HEADER --dump-command PROGRAM
   Written by `restrip-generate rules --language c`. Do not edit. */
#include <stdio.h>

#define RESTRIP_RULE_OF_@capitals@_IMPLEMENTATION
#include "restrip_rule_of_@name@.h"

static const struct {
  const char* table;
  uint32_t edges, ports, at[3];
} positions[] = {
@positions@
};

int main(void) {
  unsigned long lines = 0;
  uint32_t inner, ports;
  size_t i;
  printf("restrip-table-dump 4\n");
  for (i = 0; i < sizeof positions / sizeof *positions; ++i) {
    printf("table %s\n", positions[i].table);
    for (inner = 0; inner >> positions[i].edges == 0; ++inner)
      for (ports = 0; ports >> positions[i].ports == 0; ++ports, ++lines) {
        const restrip_operation_rule rule = restrip_rule_of_@name@(@arguments@inner, ports);
        printf("%x %x ", (unsigned)inner, (unsigned)ports);
        if (rule.valid)
          printf("%x %x %d\n", (unsigned)rule.colors, (unsigned)rule.ports, (int)rule.strips);
        else
          printf("-\n");
      }
  }
  printf("end %lu\n", lines);
  return fflush(stdout) == 0 && ferror(stdout) == 0 ? 0 : 1;
}
