// The compiler as a prover: for small fans every rule is compared with every recolouring while this file is compiled.
// A wrong table does not compile. The search below is as plain as it can be, straight from docs/notation.md, and shares
// nothing with the runtime, whose tables it asks.
//
// RESTRIP_STATIC_PROOF_K is the largest k, 4 unless told otherwise.
#include <gtest/gtest.h>

#include <iostream>

#include "restrip/rules/rules.hpp"

#ifndef RESTRIP_STATIC_PROOF_K
#define RESTRIP_STATIC_PROOF_K 4
#endif

namespace restrip {
namespace {

constexpr unsigned most_nodes = 12;
constexpr unsigned most_edges = 12;

/// A patch as edges between nodes. The first `inner` edges are the inner ones, in the order of their bits; the others
/// are the ports, each to a node of its own outside.
struct Patch {
  unsigned triangles = 0;
  unsigned nodes = 0;  ///< with those outside
  unsigned inner = 0;
  unsigned ports = 0;
  unsigned from[2 * most_edges]{};
  unsigned to[2 * most_edges]{};

  constexpr void add_edge(unsigned one, unsigned other) {
    from[inner + ports] = one;
    to[inner + ports] = other;
  }
  constexpr void add_inner_edge(unsigned one, unsigned other) {
    add_edge(one, other);
    ++inner;
  }
  /// After the last inner edge, in the order of the ports.
  constexpr void add_port(unsigned owner) {
    add_edge(owner, nodes++);
    ++ports;
  }
};

/// t_0 … t_{k-1} around a vertex.
constexpr Patch closed_fan(unsigned k) {
  Patch patch{k, k, 0, 0, {}, {}};
  for (unsigned i = 0; i < k; ++i) patch.add_inner_edge(i, (i + 1) % k);
  for (unsigned i = 0; i < k; ++i) patch.add_port(i);
  return patch;
}

/// A, t_0 … t_{a-1}, D, t_a … t_{k-1}, and the chord A - D.
constexpr Patch ring_with_chord(unsigned k, unsigned a) {
  const unsigned d = a + 1;
  Patch patch{k + 2, k + 2, 0, 0, {}, {}};
  for (unsigned i = 0; i < k + 2; ++i) patch.add_inner_edge(i, (i + 1) % (k + 2));
  patch.add_inner_edge(0, d);
  for (unsigned i = 0; i < k; ++i) patch.add_port(i < a ? i + 1 : i + 2);
  return patch;
}

/// Two triangles; the first owns the two ports named.
constexpr Patch two_triangles(unsigned one, unsigned other) {
  Patch patch{2, 2, 0, 0, {}, {}};
  patch.add_inner_edge(0, 1);
  for (unsigned port = 0; port < 4; ++port) patch.add_port(port == one || port == other ? 0 : 1);
  return patch;
}

/// What a colouring amounts to.
struct Outcome {
  bool valid = true;  ///< degrees at most two at every triangle, no solid cycle
  int solid = 0;
  int isolated = 0;
  Word joined = 0;  ///< bit ports * i + j, i < j
};

constexpr bool is_set(Word mask, unsigned i) { return (mask >> i & 1) != 0; }

/// Merges the ends of one solid edge after the other; an edge whose ends are one already closes a strip.
constexpr Outcome outcome_of(const Patch& patch, Word inner, Word ports) {
  Outcome outcome;
  unsigned group[most_nodes + most_edges]{};
  int degree[most_nodes + most_edges]{};
  for (unsigned node = 0; node < patch.nodes; ++node) group[node] = node;
  for (unsigned edge = 0; edge < patch.inner + patch.ports; ++edge) {
    if (!(edge < patch.inner ? is_set(inner, edge) : is_set(ports, edge - patch.inner))) continue;
    const unsigned one = group[patch.from[edge]];
    const unsigned other = group[patch.to[edge]];
    ++outcome.solid;
    if (++degree[patch.from[edge]] > 2 || ++degree[patch.to[edge]] > 2 || one == other) return {false, 0, 0, 0};
    for (unsigned node = 0; node < patch.nodes; ++node)
      if (group[node] == other) group[node] = one;
  }
  for (unsigned node = 0; node < patch.triangles; ++node) outcome.isolated += degree[node] == 0 ? 1 : 0;
  for (unsigned i = 0; i < patch.ports; ++i)
    for (unsigned j = i + 1; j < patch.ports; ++j)
      if (is_set(ports, i) && is_set(ports, j) && group[patch.to[patch.inner + i]] == group[patch.to[patch.inner + j]])
        outcome.joined |= Word{1} << (patch.ports * i + j);
  return outcome;
}

constexpr bool sound(const Outcome& before, const Outcome& after) {
  return after.valid && (after.joined & ~before.joined) == 0;
}

/// More solid edges, or as many and fewer isolated triangles.
constexpr bool better(const Outcome& one, const Outcome& other) {
  return one.solid != other.solid ? one.solid > other.solid : one.isolated < other.isolated;
}

struct Tally {
  unsigned valid = 0;
  unsigned invalid = 0;
  unsigned costing = 0;
  unsigned wrong = 0;
  friend constexpr bool operator==(const Tally&, const Tally&) = default;
};

/// Every configuration of `before` with so many solid edges as `ports` says, against every recolouring of `after`.
template <class AskRule>
constexpr Tally tally_of(const Patch& before, const Patch& after, Word most_inner, const AskRule& ask_rule) {
  Tally tally;
  // What the recolourings of `after` amount to, once for all configurations with the same ports.
  for (Word ports = 0; ports >> before.ports == 0; ++ports) {
    Outcome recolorings[std::size_t{1} << 8]{};
    for (Word inner = 0; inner < most_inner; ++inner) recolorings[inner] = outcome_of(after, inner, ports);
    for (Word inner = 0; inner >> before.inner == 0; ++inner) {
      const Outcome configuration = outcome_of(before, inner, ports);
      const Rule rule = ask_rule(inner, ports);
      if (rule.valid != configuration.valid) ++tally.wrong;
      ++(configuration.valid ? tally.valid : tally.invalid);
      if (!configuration.valid || !rule.valid) continue;
      const Outcome own = outcome_of(after, rule.colors, ports);
      const int strips =
          static_cast<int>(after.triangles) - static_cast<int>(before.triangles) - (own.solid - configuration.solid);
      bool right = rule.colors < most_inner && sound(configuration, own) && rule.strips == strips;
      for (Word other = 0; other < most_inner; ++other)
        if (better(recolorings[other], own) && sound(configuration, recolorings[other])) right = false;
      tally.wrong += right ? 0U : 1U;
      tally.costing += strips > 0 ? 1U : 0U;
    }
  }
  return tally;
}

template <unsigned K, unsigned A>
constexpr Tally split_tally = tally_of(closed_fan(K), ring_with_chord(K, A), Word{1} << (K + 3),
                                       [](Word loop, Word ports) {
                                         return split_rule({K, A}, loop, ports);
                                       });
template <unsigned K, unsigned A>
constexpr Tally collapse_tally = tally_of(ring_with_chord(K, A), closed_fan(K), Word{1} << K,
                                          [](Word inner, Word ports) {
                                            return collapse_rule({K, A}, inner, ports);
                                          });

// Flips: the recolouring may give ports up; each costs a solid edge and counts as one isolated triangle more.
constexpr Tally tally_of_flips() {
  const Patch before = two_triangles(0, 1);
  const Patch after = two_triangles(1, 2);
  const auto after_outcome = [&](Word inner, Word kept, Word ports) {
    Outcome outcome = outcome_of(after, inner, kept);
    for (unsigned i = 0; i < 4; ++i) outcome.isolated += is_set(ports & ~kept, i) ? 1 : 0;
    return outcome;
  };
  Tally tally;
  for (Word inner = 0; inner < 2; ++inner)
    for (Word ports = 0; ports < 16; ++ports) {
      const Outcome configuration = outcome_of(before, inner, ports);
      const FlipRule rule = flip_rule(inner != 0, static_cast<unsigned>(ports));
      if (rule.valid != configuration.valid) ++tally.wrong;
      ++(configuration.valid ? tally.valid : tally.invalid);
      if (!configuration.valid || !rule.valid) continue;
      const Outcome own = after_outcome(rule.inner ? 1 : 0, rule.ports, ports);
      bool right =
          (rule.ports & ~ports) == 0 && sound(configuration, own) && rule.strips == configuration.solid - own.solid;
      for (Word kept = 0; kept < 16; ++kept)
        for (Word other = 0; other < 2; ++other) {
          const Outcome recoloring = after_outcome(other, kept, ports);
          const bool as_good = recoloring.solid == own.solid && recoloring.isolated == own.isolated;
          const bool keeps_more = as_good && count_bits(kept) > count_bits(rule.ports);
          if ((kept & ~ports) == 0 && sound(configuration, recoloring) && (better(recoloring, own) || keeps_more))
            right = false;
        }
      tally.wrong += right ? 0U : 1U;
      tally.costing += rule.strips > 0 ? 1U : 0U;
    }
  return tally;
}
constexpr Tally flip_tally = tally_of_flips();

// The theorem. The numbers beside it are those of docs/theory.md and of the certificates' claims.
static_assert(split_tally<3, 1> == Tally{44, 20, 0, 0});
static_assert(split_tally<3, 2> == Tally{44, 20, 0, 0}, "the mirror image");
static_assert(collapse_tally<3, 1> == Tally{278, 234, 0, 0});
static_assert(collapse_tally<3, 2> == Tally{278, 234, 0, 0});
static_assert(flip_tally == Tally{25, 7, 3, 0});
#if RESTRIP_STATIC_PROOF_K >= 4
static_assert(split_tally<4, 1> == Tally{160, 96, 0, 0});
static_assert(split_tally<4, 2> == Tally{160, 96, 2, 0});
static_assert(split_tally<4, 3> == Tally{160, 96, 0, 0});
static_assert(collapse_tally<4, 1> == Tally{998, 1050, 1, 0});
static_assert(collapse_tally<4, 2> == Tally{1016, 1032, 4, 0});
static_assert(collapse_tally<4, 3> == Tally{998, 1050, 1, 0});
#endif
#if RESTRIP_STATIC_PROOF_K >= 5
static_assert(split_tally<5, 1> == Tally{572, 452, 0, 0});
static_assert(split_tally<5, 2> == Tally{572, 452, 6, 0});
static_assert(collapse_tally<5, 1> == Tally{3562, 4630, 7, 0});
static_assert(collapse_tally<5, 2> == Tally{3640, 4552, 28, 0});
#endif

// The search at run time: it must find fault with rules that are wrong, or it has proved nothing.
TEST(StaticProof, WrongRulesAreFound) {
  const Patch before = closed_fan(4);
  const Patch after = ring_with_chord(4, 2);
  const auto with = [&](const auto& spoil) {
    return tally_of(before, after, Word{1} << 7,
                    [&](Word loop, Word ports) {
                      Rule rule = split_rule({4, 2}, loop, ports);
                      if (rule.valid) spoil(rule, ports);
                      return rule;
                    })
        .wrong;
  };
  EXPECT_EQ(with([](Rule&, Word) {}), 0U);
  // Every single bit of every recolouring matters: dashed it loses an edge, solid it breaks something or miscounts.
  for (unsigned bit = 0; bit < 7; ++bit)
    EXPECT_EQ(with([&](Rule& rule, Word) { rule.colors ^= Word{1} << bit; }), 160U) << "bit " << bit;
  EXPECT_EQ(with([](Rule& rule, Word) { rule.valid = false; }), 160U);
  EXPECT_EQ(with([](Rule& rule, Word) { ++rule.strips; }), 160U);
  // One solid edge less and its cost told honestly: sound, and no longer best.
  unsigned worse = 0;
  EXPECT_EQ(with([&](Rule& rule, Word) {
              const Word less = rule.colors & (rule.colors - 1);
              if (less != rule.colors) ++worse;
              rule.strips += count_bits(rule.colors) - count_bits(less);
              rule.colors = less;
            }),
            worse);
  EXPECT_GT(worse, 150U);
}

TEST(StaticProof, TheSearchAtRunTimeSaysWhatTheCompilerSaid) {
  std::cout << "proved while this was compiled: splits, collapses and flips, k <= " << RESTRIP_STATIC_PROOF_K << '\n';
  const auto split = [](unsigned k, unsigned a) {
    return tally_of(closed_fan(k), ring_with_chord(k, a), Word{1} << (k + 3), [&](Word loop, Word ports) {
      return split_rule({k, a}, loop, ports);
    });
  };
  EXPECT_EQ(split(3, 1), (split_tally<3, 1>));
  EXPECT_EQ(split(4, 2), (Tally{160, 96, 2, 0}));
  EXPECT_EQ(split(5, 2), (Tally{572, 452, 6, 0}));
  EXPECT_EQ(split(5, 4), (Tally{572, 452, 0, 0}));
}

}  // namespace
}  // namespace restrip
