// What a model checker makes of assumptions and assertions, done by a program that asks one question after the other:
// the assertions that fail are kept, and printed at the end.
#include <stdint.h>
#include <stdio.h>
#include <string.h>

static const char* failed[16];
static int failures;

static void fails(const char* text) {
  for (int i = 0; i < failures; ++i)
    if (strcmp(failed[i], text) == 0) return;
  failed[failures++] = text;
}

static void print_failed(void) {
  for (int i = 0; i < failures; ++i) puts(failed[i]);
}

#define __CPROVER_assume(holds) \
  do                            \
    if (!(holds)) return 0;     \
  while (0)
#define __CPROVER_assert(holds, text) \
  do                                  \
    if (!(holds)) fails(text);        \
  while (0)
