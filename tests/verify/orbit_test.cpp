// Orbits of cases that can be counted on paper.

#include <gtest/gtest.h>

#include "judge/symmetry.hpp"
#include "model/description.hpp"

namespace restrip::verify {
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

}  // namespace
}  // namespace restrip::verify
