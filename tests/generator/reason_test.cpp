// Reasons as text, and how long they get. Whether they are true is the verifier's question.
#include "reason.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "solve/section.hpp"

namespace restrip::generator {
namespace {

Reason reason_of(const Section& section, const Row& row) {
  const Reasoner reasoner(operation_of_rows(section.position, Sight::patch, Goal::strips));
  return reasoner.reason(row.key.ports, row.key.joined.masks(), row);
}

TEST(Reasons, OfRulesDoneByHand) {
  const auto sections = solved("split", 4, 1);
  const Section& section = sections.back();
  ASSERT_EQ(section.position.at, 2U);
  // Ports 1 and 2 apart: their triangles have two inner edges each, A has three.
  EXPECT_EQ(reason_of(section, row_of(section, 6, {})).text(), "6 18 61");
  // No ports: with the chord A and D are full, without it the ring must not close.
  EXPECT_EQ(reason_of(section, row_of(section, 0, {})).text(), "if 6 then c 21 else 3f");
}

TEST(Reasons, NothingToShow) {
  const auto sections = solved("flip", 4, 1);
  EXPECT_EQ(reason_of(sections[0], row_of(sections[0], 0, {})).text(), "-");
}

TEST(Reasons, HaveFiveLeavesAtMost) {
  for (const std::string& family : certificates_of(families())) {
    std::size_t most = 0;
    for (const Section& section : solved(family, 7, 1))
      for (const Row& row : section.rows)
        if (row.witness < 0) most = std::max(most, reason_of(section, row).leaves());
    EXPECT_GE(most, 1U) << family;
    EXPECT_LE(most, 5U) << family;
  }
}

}  // namespace
}  // namespace restrip::generator
