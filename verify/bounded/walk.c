// The automaton's look-up in C held by a bounded model checker against the one that theorems speak of: `Lookup` of
// verify/formal/Statements.v, said here once more in C, in its words and with lists as it has them. Both read the same
// arrays, of which nothing is known but how long they are and how large their numbers, so the formula is about every
// automaton. scripts/model_check.py writes the look-up beside it, its reads in place of those of arrays, and
//
//   MOST_K: the largest fan
//   possible, ask, answer: whether there is such a position, the question, and the answer of `Lookup`
//
// Assertions that begin with "control" must fail.
#include "position.h"

enum { PLAIN, ALONE, JOINED, EDGE };

// An arc, its first letter first; `classes[n]` is the class of the first n letters.
typedef struct word {
  uint32_t length, letters[MOST_K + 1], classes[MOST_K + 2];
} word;

// A list of colours, the first one in bit 0.
typedef struct coloring {
  uint64_t solid;
  uint32_t length;
} coloring;

static uint32_t entry(const word* w, uint32_t n) { return 4 * w->classes[n] + w->letters[n]; }

static void add_letter(word* w, uint32_t letter) {
  w->letters[w->length] = letter;
  w->classes[w->length + 1] = restrip_next_at(entry(w, w->length));
  ++w->length;
}

static void add_letters(word* w, uint64_t s, uint64_t J, uint32_t i, uint32_t n) {
  for (uint32_t t = i; t < i + n; ++t) add_letter(w, (s >> t & 1) == 0 ? PLAIN : (J >> t & 1) == 0 ? ALONE : JOINED);
}

static uint32_t arc_class(const word* w) { return w->classes[w->length]; }

static coloring links(const word* w, uint32_t end) {
  coloring l = {0, w->length + 1};
  l.solid = (uint64_t)((end & 3) != 0) << w->length;
  for (uint32_t n = w->length; n-- > 0;) {
    const uint64_t low = restrip_before_at(2 * entry(w, n)), high = restrip_before_at(2 * entry(w, n) + 1);
    end = (uint32_t)((high << 32 | low) >> 4 * end) & 15;
    l.solid |= (uint64_t)((end & 3) != 0) << n;
  }
  return l;
}

static void append(coloring* list, coloring more, uint32_t from, uint32_t to) {
  for (uint32_t n = from; n < to; ++n) list->solid |= (more.solid >> n & 1) << list->length++;
}

static uint32_t meeting(const word* one, const word* other) {
  return restrip_meetings_at(
      restrip_meet_at(RESTRIP_SECONDS * restrip_first_at(arc_class(one)) + restrip_second_at(arc_class(other))));
}

static uint64_t of_closed(uint32_t k, uint64_t s, uint64_t J) {
  uint64_t both = 0;
  uint32_t solid = 0;
  for (uint32_t i = 0; i < k; ++i) {
    both |= s & J & (uint64_t)1 << i;
    solid += s >> i & 1;
  }
  return solid == 2 && both != 0 ? s : both;
}

static uint64_t of_open(uint32_t k, uint64_t s, uint64_t J) {
  uint64_t both = 0;
  _Bool behind_a_solid_one = 0;
  for (uint32_t i = 0; i < k; ++i) {
    if (behind_a_solid_one) both |= s & J & (uint64_t)1 << i;
    if (s >> i & 1) behind_a_solid_one = 1;
  }
  return both;
}

static uint64_t split_answer(uint32_t k, uint32_t a, uint64_t s, uint64_t J) {
  word w1 = {0}, w2 = {0};
  coloring answer = {0, 0};
  J = of_closed(k, s, J);
  add_letters(&w1, s, J, 0, a);
  add_letters(&w2, s, J, a, k - a);
  const uint32_t m = meeting(&w1, &w2);
  append(&answer, links(&w1, m & 15), 0, a + 1);
  append(&answer, links(&w2, m >> 4 & 15), 0, k - a + 1);
  return answer.solid | (uint64_t)(m >> 8 & 1) << answer.length;
}

static uint64_t collapse_answer(uint32_t k, uint64_t s, uint64_t J) {
  word w = {0};
  coloring answer = {0, 0};
  add_letters(&w, s, of_closed(k, s, J), 0, k);
  append(&answer, links(&w, restrip_closed_at(arc_class(&w))), 1, k + 1);
  return answer.solid;
}

static uint64_t open_split_answer(uint32_t k, uint32_t i, uint32_t j, uint64_t s, uint64_t J) {
  word w1 = {0}, w2 = {0};
  coloring answer = {0, 0};
  J = of_open(k, s, J);
  add_letters(&w1, s, J, i, j - i);
  add_letters(&w2, s, J, j, k - j);
  add_letter(&w2, EDGE);
  add_letters(&w2, s, J, 0, i);
  const uint32_t m = meeting(&w1, &w2);
  const coloring l2 = links(&w2, m >> 4 & 15);
  append(&answer, l2, k - j + 2, l2.length);
  append(&answer, links(&w1, m & 15), 0, j - i + 1);
  append(&answer, l2, 0, k - j);
  return answer.solid | (uint64_t)(m >> 8 & 1) << answer.length;
}

static uint64_t boundary_split_answer(uint32_t k, uint32_t i, uint64_t s, uint64_t J) {
  word w = {0};
  coloring answer = {0, 0};
  J = of_open(k, s, J);
  add_letters(&w, s, J, 0, i);
  add_letter(&w, PLAIN);
  add_letters(&w, s, J, i, k - i);
  append(&answer, links(&w, 0), 1, k + 1);
  return answer.solid;
}

static uint64_t fan_collapse_answer(uint32_t k, uint64_t s, uint64_t J) {
  word w = {0};
  coloring answer = {0, 0};
  add_letters(&w, s, of_open(k, s, J), 0, k);
  append(&answer, links(&w, 0), 1, k);
  return answer.solid;
}

int main(void) {
  const uint32_t k = nondet_u32(), i = nondet_u32(), j = nondet_u32();
  const restrip_key key = {nondet_u64(), nondet_u64(), nondet_u64(), nondet_u64()};
  __CPROVER_assume(k <= MOST_K);
  const restrip_recoloring asked = ask(k, i, j, key);
  __CPROVER_assert(asked.valid == possible(k, i, j), "there are answers where there is a position");
  __CPROVER_assert(!asked.valid || asked.colors == answer(k, i, j, key.ports, key.joined), "the answers are the same");
  __CPROVER_assert(asked.colors == 0, "control: nothing is solid");
}
