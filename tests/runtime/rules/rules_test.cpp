// The lookups: evaluated by the compiler, the same for mirrored and turned positions, sound and best by brute force.
#include "restrip/rules/rules.hpp"

#include <gtest/gtest.h>

#include <optional>

#include "fan_operation.hpp"
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

/// The rule of a split, or of the collapse that is its inverse.
Rule rule_of(const exact::FanOperation& split, bool splits, Word colors, Word ports) {
  const auto& [family, k, i, j] = split;
  if (family == 0) return splits ? split_rule({k, i}, colors, ports) : collapse_rule({k, i}, colors, ports);
  if (family == 2)
    return splits ? open_split_rule({k, i, j}, colors, ports) : open_collapse_rule({k, i, j}, colors, ports);
  return splits ? boundary_split_rule({k, i}, colors, ports) : boundary_collapse_rule({k, i}, colors, ports);
}

/// Every rule is sound, and its solid edges and isolated triangles are as many as the automaton's. The verifier judges
/// the tables by the definition.
std::size_t compare_all(const exact::FanOperation& split, bool splits) {
  const exact::FanOperation before = splits ? split.inverse() : split;
  const exact::FanOperation after = splits ? split : split.inverse();
  const naive::Patch patch = after.patch();
  std::size_t compared = 0;
  for (Word colors = 0; colors < bit(before.patch().edges.size()); ++colors)
    for (Word ports = 0; ports < bit(split.k); ++ports) {
      const Rule rule = rule_of(split, splits, colors, ports);
      EXPECT_EQ(rule.valid, before.after().valid(colors, ports));
      if (!rule.valid) continue;
      ++compared;
      const auto canonical = [&](Word joined) { return patch.cyclic ? canonical_joined(ports, joined) : joined; };
      const Word joined = before.after().joined(colors, ports);
      const exact::Value best = exact::best(after.after(), ports, joined).value;
      EXPECT_TRUE(after.after().valid(rule.colors, ports));
      EXPECT_EQ(canonical(after.after().joined(rule.colors, ports)) & ~canonical(joined), 0U);
      EXPECT_EQ(count_bits(rule.colors), best.solid);
      EXPECT_EQ(naive::analyze(patch, naive::bits_of(rule.colors, patch.edges.size()), naive::bits_of(ports, split.k))
                    .isolated,
                best.isolated);
      if (testing::Test::HasFailure()) return compared;
    }
  return compared;
}

TEST(Rules, AgreeWithTheExactSolverAtEveryPosition) {
  std::size_t compared = 0;
  for (const bool splits : {true, false})
    for (const int family : {0, 2, 3})
      for (std::size_t k = family == 0 ? 3 : 1; k <= (splits && family == 0 ? 8U : 6U); ++k)
        for (const exact::FanOperation& split : exact::fan_operations(family, k)) {
          SCOPED_TRACE(split.text() + (splits ? "" : ", back"));
          compared += compare_all(split, splits);
          if (HasFailure()) return;
        }
  EXPECT_GT(compared, 200000U);
}

/// All answers for an open fan: valid exactly if the colours are, and as good as the best of all recolourings.
std::size_t search_all(const exact::FanOperation& split, bool splits) {
  naive::ExhaustiveSearch before((splits ? split.inverse() : split).patch());
  naive::ExhaustiveSearch after((splits ? split : split.inverse()).patch());
  const std::size_t edges = (splits ? split.inverse() : split).patch().edges.size();
  std::size_t compared = 0;
  for (Word ports = 0; ports < bit(split.k); ++ports) {
    before.solve(ports);
    after.solve(ports);
    for (Word colors = 0; colors < bit(edges); ++colors, ++compared) {
      const Rule rule = rule_of(split, splits, colors, ports);
      const std::optional<naive::Mask> key = before.key(colors);
      if (rule.valid == key.has_value() && (!key || after.judge(rule.colors, *key) == after.best(*key))) continue;
      ADD_FAILURE() << "colours " << colors << ", ports " << ports << ": answered " << rule.colors;
      return compared;
    }
  }
  return compared;
}

// The automaton answers open fans, so nothing else checks the way from their colours to its answers in C++.
TEST(Rules, OpenFansAreAnsweredAsWellAsASearchDoes) {
  std::size_t compared = 0;
  for (const int family : {2, 3})
    for (std::size_t k = 1; k <= 8; ++k)
      for (const exact::FanOperation& split : exact::fan_operations(family, k))
        for (const bool splits : {true, false}) {
          SCOPED_TRACE(split.text() + (splits ? "" : ", back"));
          compared += search_all(split, splits);
          if (HasFailure()) return;
        }
  std::size_t all = 0;
  for (std::size_t k = 1; k <= 8; ++k)
    all += (k * (k + 1) / 2 * (1 + 8) + (k + 1) * (1 + 2))
           << (2 * k - 1);  // colours before: k - 1, or k + 2; k - 1, or k
  EXPECT_EQ(compared, all);
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
