// The lookups: evaluated by the compiler, the same for mirrored and turned positions, sound and best by brute force.
#include "restrip/rules/rules.hpp"

#include <gtest/gtest.h>

#include "restrip/operations/operations.hpp"

namespace restrip {
namespace {

#ifdef RESTRIP_SMALL_TABLES
static_assert(table_max_k == RESTRIP_SMALL_TABLES, "this program has smaller tables");
#endif

// At compile time: an empty 4-fan gets five triangles in one strip or two; a solid loop is not a stripification.
static_assert(split_rule({4, 2}, 0, 0).valid);
static_assert(split_rule({4, 2}, 0, 0).strips == 2 - 5);
static_assert(!split_rule({4, 2}, 0b1111, 0).valid);
static_assert(!split_rule({4, 2}, 0b0011, 0b0010).valid);
static_assert(noexcept(split_rule({4, 2}, 0, 0)) && noexcept(collapse_rule({4, 2}, 0, 0)) && noexcept(flip_rule(false,
                                                                                                                0)));
// Small tables (docs/reference/tables.md) leave more to it.
static_assert(split_rule({12, 5}, 0b100, 0).valid, "beyond the tables the automaton answers, at compile time too");
static_assert(collapse_rule({3, 1}, 0, 0).valid && open_split_rule({1, 0, 1}, 0, 0).valid &&
              boundary_split_rule({1, 1}, 0, 1).valid && open_collapse_rule({2, 0, 2}, 0, 0).valid &&
              boundary_collapse_rule({2, 1}, 0, 0).valid && flip_rule(true, 0).valid);

/// Solid edges and isolated triangles of the rule equal the automaton's, which was compared with brute force.
void expect_cost(const detail::Layout& after, const Rule& rule, Word ports, const exact::Value& best) {
  EXPECT_EQ(count_bits(rule.colors), best.solid);
  EXPECT_EQ(detail::isolated(after, rule.colors, ports), best.isolated);
}

TEST(Rules, TablesAgreeWithTheExactSolverAtEveryPosition) {
  std::size_t compared = 0;
  for (std::size_t k = 3; k <= 8; ++k) {
    for (Word loop = 0; loop < bit(k); ++loop) {
      for (Word ports = 0; ports < bit(k); ++ports) {
        const bool valid = valid_closed(k, loop, ports);
        const Word joined = valid ? joined_closed(k, loop, ports) : 0;
        for (std::size_t a = 1; a < k; ++a) {
          const Rule rule = split_rule({k, a}, loop, ports);
          ASSERT_EQ(rule.valid, valid);
          if (!valid) continue;
          const auto after = detail::ring_with_chord(k, a);
          ASSERT_TRUE(valid_ring(k, a, rule.colors, ports));
          const Word now = canonical_joined(ports, joined_ring(k, a, rule.colors, ports));
          ASSERT_EQ(now & ~canonical_joined(ports, joined), 0U) << k << ' ' << a << ' ' << loop << ' ' << ports;
          expect_cost(after, rule, ports, exact::best_split(k, a, ports, joined).value);
          ++compared;
        }
      }
    }
  }
  EXPECT_GT(compared, 200000U);
}

TEST(Rules, OpenFansAgreeWithTheExactSolverAtEveryPosition) {
  for (std::size_t k = 1; k <= 6; ++k) {
    for (Word loop = 0; loop < bit(k - 1); ++loop) {
      for (Word ports = 0; ports < bit(k); ++ports) {
        if (!valid_open(k, loop, ports)) continue;
        const Word joined = joined_open(k, loop, ports);
        for (std::size_t i = 0; i <= k; ++i) {
          const Rule one = boundary_split_rule({k, i}, loop, ports);
          ASSERT_TRUE(valid_path(k, i, one.colors, ports));
          ASSERT_EQ(joined_path(k, i, one.colors, ports) & ~joined, 0U);
          expect_cost(detail::path(k, i), one, ports, exact::best_boundary_split(k, i, ports, joined).value);
          for (std::size_t j = i + 1; j <= k; ++j) {
            const Rule two = open_split_rule({k, i, j}, loop, ports);
            ASSERT_TRUE(valid_path_with_chord(k, i, j, two.colors, ports));
            ASSERT_EQ(joined_path_with_chord(k, i, j, two.colors, ports) & ~joined, 0U);
            expect_cost(detail::path_with_chord(k, i, j), two, ports,
                        exact::best_open_split(k, i, j, ports, joined).value);
          }
        }
      }
    }
  }
}

TEST(Rules, CollapsesAgreeWithTheExactSolver) {
  for (std::size_t k = 3; k <= 6; ++k) {
    for (std::size_t a = 1; a < k; ++a) {
      for (Word inner = 0; inner < bit(k + 3); ++inner) {
        for (Word ports = 0; ports < bit(k); ++ports) {
          const Rule rule = collapse_rule({k, a}, inner, ports);
          ASSERT_EQ(rule.valid, valid_ring(k, a, inner, ports));
          if (!rule.valid) continue;
          const Word joined = joined_ring(k, a, inner, ports);
          ASSERT_TRUE(valid_closed(k, rule.colors, ports));
          expect_cost(detail::closed_fan(k), rule, ports, exact::best_collapse(k, ports, joined).value);
        }
      }
    }
  }
}

TEST(Rules, FlipsKeepPortsWhereTheyCan) {
  std::size_t valid = 0;
  for (const bool inner : {false, true}) {
    for (unsigned ports = 0; ports < 16; ++ports) {
      const FlipRule rule = flip_rule(inner, ports);
      const bool degrees = !(inner && ((ports & 3U) == 3U || (ports & 12U) == 12U));
      ASSERT_EQ(rule.valid, degrees);
      if (!rule.valid) continue;
      ++valid;
      EXPECT_EQ(rule.ports & ~ports, 0U);
      EXPECT_LE(rule.strips, 1);
      EXPECT_FALSE(rule.inner && ((rule.ports & 6U) == 6U || (rule.ports & 9U) == 9U));
      if (count_bits(ports) <= 1) {
        EXPECT_EQ(rule.ports, ports);
      }
    }
  }
  EXPECT_EQ(valid, 25U);
}

}  // namespace
}  // namespace restrip
