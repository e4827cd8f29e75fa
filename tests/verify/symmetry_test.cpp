// Symmetries: orbits of cases that can be counted on paper; positions without rules must be images of positions with
// rules, and the bounds of a description hold for the answers of a table at every position.

#include "judge/symmetry.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "definition/definition.hpp"
#include "judge/family_report.hpp"
#include "judge/table_dump.hpp"
#include "model/description.hpp"

namespace restrip::verify::test {
namespace {

Operation operation_named(const std::string& name) {
  for (const Family& family : all_families())
    for (const Section& section : family.sections)
      for (const Operation& operation : section.operations)
        if (operation.name() == name) return operation;
  throw std::logic_error(name);
}

std::vector<bool> everything(const Operation& operation) {
  return std::vector<bool>(mask_count(operation.before.colors()), true);
}

OrbitCounts merged(const Operation& operation, const std::vector<bool>& valid) {
  return merged_orbits(operation, Symmetries(operation, Symmetries::Keep::both_sides), valid);
}

TEST(Orbits, SymmetriesOfASplit) {
  const auto order = [](const std::string& name, Symmetries::Keep keep) {
    const Operation operation = operation_named(name);
    return Symmetries(operation, keep).order();
  };
  EXPECT_EQ(order("split k 8 a 3", Symmetries::Keep::both_sides), 2);
  EXPECT_EQ(order("split k 8 a 4", Symmetries::Keep::both_sides), 4);
  EXPECT_EQ(order("collapse k 8 a 3", Symmetries::Keep::both_sides), 2);
  EXPECT_EQ(order("collapse k 8 a 3", Symmetries::Keep::after), 16);
  EXPECT_EQ(order("open-split k 5 gaps 1 4", Symmetries::Keep::both_sides), 2);
  EXPECT_EQ(order("open-split k 5 gaps 1 3", Symmetries::Keep::both_sides), 1);
  EXPECT_EQ(order("flip", Symmetries::Keep::both_sides), 4);
}

// One mirror fixes 2^(1 + 2) loop edge and port orbits of (k, a) = (3, 1): (64 + 16) / 2 = 40.
TEST(Orbits, OfTheSmallestSplit) {
  const Operation split = operation_named("split k 3 a 1");
  EXPECT_EQ(merged(split, everything(split)).all, 40U);
}

TEST(Orbits, DistinguishWhatSymmetriesKeep) {
  const Operation flip = operation_named("flip");
  std::vector<bool> two(32, false);
  two[0] = two[31] = true;
  EXPECT_EQ(merged(flip, two).valid, 2U);
  EXPECT_EQ(merged(flip, everything(flip)).all, 14U);
  // Three ports of which two are on one triangle after the operation: only these can trade places.
  Operation three;
  three.cost = default_cost(Constraint::strips);
  three.before = {1, {}, {0, 0, 0}, {}, {}, {}};
  three.after = {2, {{0, 1}}, {0, 0, 1}, {}, {}, {}};
  EXPECT_EQ(merged(three, everything(three)).all, 6U);
  // A port that may not be given up differs from one that may.
  Operation one_stays = flip;
  one_stays.may_give_up = 14;
  EXPECT_EQ(merged(one_stays, everything(one_stays)).all, 32U);
}

// ---- positions without rules

/// Boundary splits with other listed positions and bounds.
Family boundary_splits(const std::string& listed, const std::string& bounds) {
  return families_of(parse_descriptions(
                         "f", fmt::format(R"x({{"restrip_operation": 1, "name": "index-own", "numbers": ["k", "i"],
                                        "where": "k >= 1, i <= k", "listed": "{}", "at_most": [{}],
                                        "boundary": [["u[k]", "u[0]"]], "before": [["v", "u[j]", "u[j+1]", "j[0,k)"]],
                                        "after": [["v", "u[j]", "u[j+1]", "j[0,i)"], ["v", "u[i]", "w"],
                                                  ["w", "u[j]", "u[j+1]", "j[i,k)"]]}})x",
                                          listed, bounds)),
                     4)
      .front();
}

std::vector<ClaimResult> claims_on_images(const Family& family) {
  std::vector<ClaimResult> claims;
  report_images(family, [&](const ClaimResult& claim) { claims.push_back(claim); });
  return claims;
}

TEST(Unlisted, ImagesAreMirrored) {
  EXPECT_TRUE(claims_on_images(boundary_splits("i >= 0", "")).empty());
  for (const std::string listed : {"i = 1", "2 i <= k", "i = 0", "2 i >= k", "i < 2"}) {
    const Family family = boundary_splits(listed, "");
    std::vector<Numbers> rules;
    for (const Section& section : family.sections) rules.push_back(section.operations.front().numbers);
    std::uint64_t others = 0;
    for (const Operation& operation : family.unlisted) {
      const unsigned k = operation.numbers[0];
      others += std::count(rules.begin(), rules.end(), Numbers{k, k - operation.numbers[1]}) == 0 ? 1U : 0U;
    }
    const std::vector<ClaimResult> claims = claims_on_images(family);
    ASSERT_EQ(claims.size(), 1U);
    EXPECT_EQ(claims[0].failures.count, others) << listed;
    EXPECT_EQ(claims[0].cases, family.unlisted.size());
    EXPECT_EQ(others == 0, listed.starts_with("2 i")) << listed;
  }
}

TEST(Unlisted, AnImageHasTheSamePortsGivenUpConstraintAndCost) {
  const Operation one = boundary_splits("i >= 0", "").sections.back().operations.front();
  EXPECT_TRUE(isomorphic(one, one));
  Operation other = one;
  other.constraint = Constraint::matching;
  EXPECT_FALSE(isomorphic(one, other));
  other = one;
  other.may_give_up = 1;
  EXPECT_FALSE(isomorphic(one, other));
  other = one;
  other.cost.pop_back();
  EXPECT_FALSE(isomorphic(one, other));
  other = one;
  std::swap(other.before, other.after);
  EXPECT_FALSE(isomorphic(one, other));
}

/// What a table with a best answer everywhere exceeds.
Failures beyond(const Family& family, const std::string& position, std::uint64_t& bounded) {
  ExpectedDump expected;
  for (const Operation& operation : family.unlisted)
    if (operation.position == position) expected.tables.push_back({&operation, Against::own_patch, nullptr});
  const Definition definition(*expected.tables.at(0).operation);
  const DumpComparison found =
      compare_answers(expected, [&](const Operation& /*operation*/, Colors before) -> std::optional<Answer> {
        if (!definition.valid(before)) return {};
        return Answer{definition.best(before)->colors, {}, {}};
      });
  bounded = found.bounded.entries;
  EXPECT_EQ(found.of(Against::own_patch).wrong.count, 0U);
  EXPECT_EQ(found.agrees(), found.beyond.count == 0);
  return found.beyond;
}

TEST(Unlisted, AnswersAreComparedWithTheBounds) {
  // At gap 0 of three triangles the new triangle may cost a strip; no triangle becomes isolated.
  std::uint64_t bounded = 0;
  EXPECT_EQ(beyond(boundary_splits("i = 1", ""), "k 3 i 0", bounded).count, 0U);
  EXPECT_EQ(bounded, 0U);
  EXPECT_GT(beyond(boundary_splits("i = 1", R"({"strips": 0})"), "k 3 i 0", bounded).count, 0U);
  EXPECT_EQ(bounded, 32U);
  EXPECT_EQ(
      beyond(boundary_splits("i = 1", R"({"strips": 1, "isolated": 1, "indices": 16})"), "k 3 i 0", bounded).count, 0U);
  EXPECT_GT(beyond(boundary_splits("i = 1", R"({"isolated": -1})"), "k 3 i 0", bounded).count, 0U);
  EXPECT_GT(beyond(boundary_splits("i = 1", R"({"indices": 2})"), "k 3 i 0", bounded).count, 0U);
  EXPECT_EQ(beyond(boundary_splits("i = 1", R"({"where": "i = 1", "strips": -1})"), "k 3 i 0", bounded).count, 0U);
  EXPECT_EQ(bounded, 0U);
}

}  // namespace
}  // namespace restrip::verify::test
