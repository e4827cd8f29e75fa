// Asks verify/bounded/look_up.c, or the judge of keys beside it, what a model checker asks it, one number after the
// other, and prints the assertions that fail. BITS is how many bits the numbers have, in the order of the questions.
#include "model_checker.h"

static uint32_t asked[4];
static int at;

#define nondet_u32() asked[at++]
#define main judged
#include JUDGE
#undef main

int main(void) {
  const int bits[] = {BITS}, questions = sizeof bits / sizeof *bits;
  for (int digit = 0; digit < questions;) {
    at = 0;
    judged();
    // One bit more than there is: colours with it are not valid.
    for (digit = 0; digit < questions && ++asked[digit] == 2U << bits[digit]; ++digit) asked[digit] = 0;
  }
  print_failed();
  return 0;
}
