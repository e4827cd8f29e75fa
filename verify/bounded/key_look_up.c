// A look-up by keys in C held by a bounded model checker against every recolouring of one patch: for all pairs of masks
// at once, no run but a formula. scripts/model_check.py writes the patch after the operation beside it and asks the
// look-up:
//
//   TRIANGLES_AFTER, EDGES_AFTER, PORTS, MOST, ONE_RECOLORING, after_one, after_other, after_owner: as for look_up.c
//   CLOSED: whether the first port comes after the last one
//   RESTART, ISOLATED: what a strip and an isolated triangle cost
//   ask: the question
//
// Assertions that begin with "control" must fail, as there.
typedef unsigned int u32;
typedef struct answer {
  u32 inner;
  _Bool valid;
} answer;

#include "position.h"

enum { MOST_TRIANGLES = TRIANGLES_AFTER, MOST_BITS = 20 };

#ifndef nondet_u32
u32 nondet_u32(void);
#endif

#include "side.h"

static side after(u32 inner, u32 ports) {
  return drawn(TRIANGLES_AFTER, EDGES_AFTER, after_one, after_other, after_owner, inner, ports);
}

// Valid, and joins only ports that follow each other and of which the later one is marked.
static _Bool sound(const side* new, u32 ports, u32 joined) {
  _Bool holds = new->valid;
  for (u32 q = 0; q < PORTS; ++q)
    for (u32 p = 0; p < q; ++p) {
      const u32 from_p_to_q = ((u32)2 << q) - ((u32)1 << p), both = (u32)1 << p | (u32)1 << q;
      const _Bool in_order = (joined >> q & 1) && (ports & from_p_to_q) == both;
      const _Bool around = CLOSED && (joined >> p & 1) && (ports & ~from_p_to_q) == 0;
      if ((ports & both) == both && new->strip[after_owner[p]] == new->strip[after_owner[q]] && !in_order && !around)
        holds = 0;
    }
  return holds;
}

// Smaller is better.
static u32 cost(const side* new, u32 inner) {
  return RESTART * (EDGES_AFTER - count(inner)) + ISOLATED * new->isolated;
}

int main(void) {
  const u32 any_ports = nondet_u32(), joined = nondet_u32();
  const answer rule = ask(any_ports, joined);
  const u32 ports = any_ports & (((u32)1 << PORTS) - 1);
  __CPROVER_assert(rule.valid, "every key has an answer");
  const side new = after(rule.inner, ports);
  __CPROVER_assert(sound(&new, ports, joined), "the rule is sound");

  const u32 other_inner = nondet_u32();
  const side other = after(other_inner, ports);
  __CPROVER_assume(sound(&other, ports, joined));
  const u32 own = cost(&new, rule.inner), compared = cost(&other, other_inner);
  __CPROVER_assert(own <= compared, "nothing is better");
  __CPROVER_assert(own != compared, "control: nothing is as good");
#ifndef ONE_RECOLORING
  __CPROVER_assert(own >= compared, "control: nothing is worse");
#endif
}
