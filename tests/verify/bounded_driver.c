// Asks verify/bounded/look_up.c, or the judge of keys beside it, what a model checker asks it, one number after the
// other, and prints the assertions that fail.
#include <stdint.h>
#include <stdio.h>
#include <string.h>

static uint32_t asked[4];
static int at;
static const char* failed[16];
static int failures;

static void fails(const char* text) {
  for (int i = 0; i < failures; ++i)
    if (strcmp(failed[i], text) == 0) return;
  failed[failures++] = text;
}

#define nondet_u32() asked[at++]
#define __CPROVER_assume(holds) \
  do                            \
    if (!(holds)) return 0;     \
  while (0)
#define __CPROVER_assert(holds, text) \
  do                                  \
    if (!(holds)) fails(text);        \
  while (0)
#define main judged
#include JUDGE
#undef main

int main(void) {
  // One bit more than there is: colours with it are not valid.
  const uint32_t end[4] = {2U << EDGES_BEFORE, 2U << PORTS, 2U << EDGES_AFTER, 2U << PORTS};
  uint32_t next[4] = {0, 0, 0, 0};
  for (int digit = 0; digit < 4;) {
    memcpy(asked, next, sizeof asked);
    at = 0;
    judged();
    for (digit = 0; digit < 4 && ++next[digit] == end[digit]; ++digit) next[digit] = 0;
  }
  for (int i = 0; i < failures; ++i) puts(failed[i]);
  return 0;
}
