// Reasons as text, and their length. The verifier checks whether they are true.
#include <gtest/gtest.h>

#include <algorithm>

#include "certify/certificate.hpp"
#include "describe/description.hpp"
#include "solved.hpp"

namespace restrip::generator {
namespace {

FoundReason found_reason(const Section& section, const Row& row) {
  const Reasoner reasoner(operation_of_rows(section.position));
  return reasoner.find(row.key.ports, row.key.joined.masks(), row);
}

Reason reason_of(const Section& section, const Row& row) { return found_reason(section, row).reason; }

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
        if (row.witness < 0) {
          const FoundReason found = found_reason(section, row);
          most = std::max(most, found.reason.leaves());
          EXPECT_TRUE(found.smallest);
          EXPECT_LE(found.steps * 4, most_steps_of_smallest_reason);
        }
    EXPECT_GE(most, 1U) << family;
    EXPECT_LE(most, 5U) << family;
  }
}

/// The only operation of a file, and its rules.
struct Solved {
  std::vector<Description> descriptions;
  Section section;

  explicit Solved(const std::string& file)
      : descriptions(read_descriptions({file})), section(solve(patches_of(descriptions, default_max_k).at(0))) {}
};

// One of the red-green refinement takes the most steps of all shipped rules.
TEST(Reasons, OfAShippedOperationTakeAQuarterOfTheSteps) {
  const Solved solved(RESTRIP_CORPUS_DIR "/../../tables/operations/refine-face.json");
  std::uint64_t most = 0;
  for (const Row& row : solved.section.rows) {
    if (row.witness >= 0) continue;
    const FoundReason found = found_reason(solved.section, row);
    EXPECT_TRUE(found.smallest);
    most = std::max(most, found.steps);
  }
  EXPECT_GT(most, 100'000U);
  EXPECT_LE(most * 4, most_steps_of_smallest_reason);
}

// Seven triangles around a vertex become five, and any port may be given up: the smallest reasons of some rules have
// more than twenty leaves. A search among all trees would take years.
TEST(Reasons, AreFoundWithinTheStepLimit) {
  const Solved solved(RESTRIP_CORPUS_DIR "/operations/seven-to-five.json");
  const Reasoner reasoner(operation_of_rows(solved.section.position));
  std::size_t smallest = 0;
  std::size_t larger = 0;
  std::uint64_t steps = 0;
  for (const Row& row : solved.section.rows) {
    if (row.witness >= 0) continue;
    const std::vector<Mask> joined = row.key.joined.masks();
    const FoundReason found = reasoner.find(row.key.ports, joined, row);
    ++(found.smallest ? smallest : larger);
    steps += found.steps;
    EXPECT_LE(found.steps, most_steps_of_smallest_reason + 10'000);
    // A reason made without the search is not smaller, and takes few steps.
    const FoundReason made = reasoner.find(row.key.ports, joined, row, 0);
    EXPECT_FALSE(made.smallest);
    EXPECT_LE(made.steps, 10'000U);
    if (found.smallest)
      EXPECT_GE(made.reason.leaves(), found.reason.leaves());
    else
      EXPECT_EQ(made.reason.text(), found.reason.text());
    EXPECT_LE(made.reason.leaves(), 32U);
  }
  EXPECT_EQ(smallest + larger, 436U);
  EXPECT_GE(larger, 1U);
  EXPECT_LE(larger, 30U);
  EXPECT_LE(steps, 6'000'000U);
}

}  // namespace
}  // namespace restrip::generator
