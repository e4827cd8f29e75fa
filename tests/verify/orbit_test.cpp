// Both ways to count orbits, on cases that can be counted on paper.

#include <gtest/gtest.h>

#include "orbits.hpp"
#include "symmetry.hpp"

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
  return std::vector<bool>(mask_count(operation.before.inner_edges() + operation.before.ports()), true);
}

TEST(Orbits, SymmetriesOfASplit) {
  EXPECT_EQ(configuration_symmetries(operation_named("split k 8 a 3")).size(), 2U);
  EXPECT_EQ(configuration_symmetries(operation_named("split k 8 a 4")).size(), 4U);
  EXPECT_EQ(configuration_symmetries(operation_named("open-split k 5 gaps 1 4")).size(), 2U);
  EXPECT_EQ(configuration_symmetries(operation_named("open-split k 5 gaps 1 3")).size(), 1U);
  EXPECT_EQ(configuration_symmetries(operation_named("flip")).size(), 4U);
}

// One mirror fixes 2^(1 + 2) loop edge and port orbits of (k, a) = (3, 1): (64 + 16) / 2 = 40.
TEST(Orbits, OfTheSmallestSplit) {
  const Operation split = operation_named("split k 3 a 1");
  EXPECT_EQ(burnside_orbits(split, everything(split)).all, 40U);
  EXPECT_EQ(nauty_orbits(split, everything(split)).all, 40U);
}

// Nothing but the colours' numbers tells all solid from all dashed: the trap of canonical graphs.
TEST(Orbits, NautyTellsColorsApart) {
  const Operation flip = operation_named("flip");
  std::vector<bool> two(32, false);
  two[0] = two[31] = true;
  EXPECT_EQ(nauty_orbits(flip, two).valid, 2U);
  EXPECT_EQ(nauty_orbits(flip, everything(flip)).all, 14U);
}

}  // namespace
}  // namespace restrip::verify
