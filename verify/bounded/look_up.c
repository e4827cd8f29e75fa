// A look-up in C held by a bounded model checker against every recolouring of one patch: for all colours and ports at
// once, no run but a formula. scripts/model_check.py writes the patch beside it and asks the look-up:
//
//   TRIANGLES_BEFORE, EDGES_BEFORE, TRIANGLES_AFTER, EDGES_AFTER, PORTS
//   before_one, before_other, after_one, after_other: the two triangles of each inner edge
//   before_owner, after_owner: the triangle of each port
//   MOST: solid edges of a triangle at most
//   MAY_GO: the ports that a rule may give up
//   COUNTS: whether fewer strips come first; if not, fewer isolated triangles and ports given up do
//   ANY_COLORS: whether the look-up may answer colours that are not valid
//   ONE_RECOLORING: defined where there is no edge to choose
//   ask: the question
//
// Assertions that begin with "control" must fail: they show that there are answers to judge, that a recolouring as good
// as the rule exists among those compared, and that worse ones do.
typedef unsigned int u32;
typedef struct answer {
  u32 inner, ports;
  int strips;
  _Bool valid;
} answer;

#include "position.h"

enum { MOST_TRIANGLES = TRIANGLES_BEFORE > TRIANGLES_AFTER ? TRIANGLES_BEFORE : TRIANGLES_AFTER, MOST_BITS = 20 };

#ifndef nondet_u32
u32 nondet_u32(void);
#endif

#include "side.h"

static side before(u32 inner, u32 ports) {
  return drawn(TRIANGLES_BEFORE, EDGES_BEFORE, before_one, before_other, before_owner, inner, ports);
}
static side after(u32 inner, u32 ports) {
  return drawn(TRIANGLES_AFTER, EDGES_AFTER, after_one, after_other, after_owner, inner, ports);
}

// Valid, gives up only what may go, and joins no two ports that were not joined.
static _Bool sound(const side* old, u32 old_ports, const side* new, u32 ports) {
  _Bool holds = new->valid && (ports & ~old_ports) == 0 && (old_ports & ~ports & ~(u32)(MAY_GO)) == 0;
  for (u32 p = 0; p < PORTS; ++p)
    for (u32 q = 0; q < p; ++q)
      if ((ports >> p & 1) && (ports >> q & 1) && new->strip[after_owner[p]] == new->strip[after_owner[q]] &&
          old->strip[before_owner[p]] != old->strip[before_owner[q]])
        holds = 0;
  return holds;
}

// The order of preference: strips, then isolated triangles and ports given up, then ports given up. Smaller is better.
static u32 cost(const side* new, u32 inner, u32 ports, u32 old_ports) {
  const u32 given_up = count(old_ports & ~ports), lost = new->isolated + given_up;
  const u32 dashed = EDGES_AFTER - count(inner) + given_up;
  return (COUNTS ? dashed << 10 : 0) | lost << 5 | given_up;
}

int main(void) {
  const u32 inner = nondet_u32(), ports = nondet_u32();
  const answer rule = ask(inner, ports);
  const side old = before(inner, ports);
  __CPROVER_assert(ANY_COLORS || rule.valid == old.valid, "an answer exactly where the colours are valid");
  __CPROVER_assert(rule.valid || (rule.inner == 0 && rule.ports == 0 && rule.strips == 0), "no answer is all zero");
  __CPROVER_assume(old.valid);
  __CPROVER_assert(rule.valid, "valid colours have an answer");
  const side new = after(rule.inner, rule.ports);
  __CPROVER_assert(sound(&old, ports, &new, rule.ports), "the rule is sound");
  __CPROVER_assert(rule.strips == (int)(TRIANGLES_AFTER - count(rule.inner) + count(ports)) -
                                      (int)(TRIANGLES_BEFORE - count(inner) + count(rule.ports)),
                   "the change in the number of strips is told");

  const u32 other_inner = nondet_u32(), other_ports = nondet_u32();
  const side other = after(other_inner, other_ports);
  __CPROVER_assume(sound(&old, ports, &other, other_ports));
  const u32 own = cost(&new, rule.inner, rule.ports, ports);
  const u32 compared = cost(&other, other_inner, other_ports, ports);
  __CPROVER_assert(own <= compared, "nothing is better");
  __CPROVER_assert(own != compared, "control: nothing is as good");
#ifndef ONE_RECOLORING
  __CPROVER_assert(own >= compared, "control: nothing is worse");
#endif
}
