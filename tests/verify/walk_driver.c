// Asks verify/bounded/walk.c what a model checker asks it, small fans, positions and masks one after the other, with
// arbitrary numbers in place of those of the automaton, and prints the assertions that fail.
#include "model_checker.h"

static uint32_t numbers[3], seed;
static uint64_t masks[4];
static int next_number, next_mask;

uint32_t nondet_u32(void) { return numbers[next_number++]; }
uint64_t nondet_u64(void) { return masks[next_mask++]; }

static uint32_t any_number(const char* name, uint32_t i, uint32_t largest) {
  uint64_t mixed = seed + i * UINT64_C(0x9e3779b97f4a7c15);
  for (; *name != 0; ++name) mixed = (mixed ^ (unsigned char)*name) * UINT64_C(0xbf58476d1ce4e5b9) ^ mixed >> 29;
  return (uint32_t)((mixed >> 16) % ((uint64_t)largest + 1));
}

#define main walked
#include "walk.c"
#undef main

int main(void) {
  const uint32_t end = 2U << MOST_K;
  for (seed = 0; seed < 3; ++seed)
    for (uint32_t position = 0; position < 6 * 6 * 6; ++position)
      for (uint32_t mask = 0; mask < end * end; ++mask) {
        numbers[0] = position / 36, numbers[1] = position / 6 % 6, numbers[2] = position % 6;
        masks[0] = mask / end, masks[1] = mask % end;
        next_number = next_mask = 0;
        walked();
      }
  print_failed();
  return 0;
}
