// Reasons as text, and their length. The verifier checks whether they are true. The rules of splits and collapses are
// best only among the recolourings that keep their ports (docs/explanation/theory.md, "Ports given up"): the example of
// that section, a split with k = 5 and a = 2, solved by the generator's search and by trying all recolourings on the
// ring with chord, numbered as in docs/reference/notation.md, in every outside.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <vector>

#include "../runtime/naive_patch.hpp"
#include "certify/certificate.hpp"
#include "describe/description.hpp"
#include "solve/section.hpp"

namespace restrip::generator {
namespace {

/// The sections of one certificate of the shipped families.
std::vector<Section> solved(const std::string& certificate, unsigned max_k, unsigned threads) {
  std::vector<Patches> patches = patches_of(families(), max_k);
  std::erase_if(patches, [&](const Patches& one) { return one.certificate != certificate; });
  return solve_all(patches, threads);
}

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

constexpr unsigned k = 5;
constexpr unsigned inner_edges_after = k + 3;
constexpr Mask ports = 0x15;  // 0, 2 and 4
constexpr Mask rule = 0x2d;
constexpr Mask bolder = 0xf6;
constexpr Mask bolder_keeps = 0x5;

/// e_0 and e_1 are solid before the split, so that ports 0 and 2 are joined.
naive::Pairs joined_before() {
  const auto before = naive::analyze(naive::closed_fan(k), naive::bits_of(0b11, k), naive::bits_of(ports, k));
  EXPECT_TRUE(before.valid);
  return before.joined;
}

/// In every outside: a strip there joins two of the three ports, unless it closes a cycle before the split.
bool is_sound(Mask recoloring, Mask kept) {
  const auto after = naive::analyze(naive::ring_with_chord(k, 2), naive::bits_of(recoloring, inner_edges_after),
                                    naive::bits_of(kept, k));
  return after.valid && naive::subset(after.joined, joined_before());
}

int solid(Mask recoloring, Mask kept) { return std::popcount(recoloring) + std::popcount(kept); }

/// The most solid edges of a sound recolouring that keeps ports for which `may` is true.
template <class May>
int most_solid(May may) {
  int most = -1;
  for (Mask kept = 0; kept < 1U << k; ++kept)
    for (Mask recoloring = 0; (kept & ~ports) == 0 && may(kept) && recoloring < 1U << inner_edges_after; ++recoloring)
      if (is_sound(recoloring, kept)) most = std::max(most, solid(recoloring, kept));
  return most;
}

TEST(PortsGivenUp, TheRuleIsBestIfAllAreKept) {
  EXPECT_EQ(joined_before(), (naive::Pairs{{0, 2}}));  // so a strip outside leads to port 4, from 0 or from 2
  EXPECT_TRUE(is_sound(rule, ports));
  EXPECT_EQ(solid(rule, ports), 7);
  EXPECT_EQ(most_solid([](Mask kept) { return kept == ports; }), 7);
}

TEST(PortsGivenUp, OneGivenUpSavesAStrip) {
  EXPECT_TRUE(is_sound(bolder, bolder_keeps));
  EXPECT_EQ(solid(bolder, bolder_keeps), 8);
  EXPECT_EQ(most_solid([](Mask) { return true; }), 8);
  EXPECT_FALSE(is_sound(bolder, ports));  // the port that it gives up is in its way
}

TEST(PortsGivenUp, TheGeneratorFindsBoth) {
  const Position position{&family_named("split"), k, 2, 0};
  PortPairs joined;
  joined.add(0, 2);
  std::size_t compared = 0;
  for (const Section& section : solved("split", k, 1)) {
    if (section.position != position) continue;
    EXPECT_EQ(row_of(section, ports, joined).recoloring, rule);
    ++compared;
  }
  EXPECT_EQ(compared, 1U);

  // A and D are the triangles v u0 w and w u2 v.
  std::vector<Description> file = parse_descriptions("file.json", R"({"restrip_operation": 1, "name": "split-own",
    "before": [["v", "u0", "u1"], ["v", "u1", "u2"], ["v", "u2", "u3"], ["v", "u3", "u4"], ["v", "u4", "u0"]],
    "after": [["v", "u0", "w"], ["w", "u0", "u1"], ["w", "u1", "u2"], ["w", "u2", "v"],
              ["v", "u2", "u3"], ["v", "u3", "u4"], ["v", "u4", "u0"]]})");
  const auto row = [&] {
    const Section own = solve(patches_of(file, k).at(0));
    return row_of(own, ports, joined);
  };
  const Row keeping = row();
  EXPECT_EQ(solid(keeping.recoloring, keeping.kept), 7);
  EXPECT_EQ(keeping.kept, ports);

  file.at(0).may_give_up = ~Mask{0};
  file.at(0).preference.resize(1);  // only strips
  const Row giving = row();
  EXPECT_EQ(solid(giving.recoloring, giving.kept), 8);
}

}  // namespace
}  // namespace restrip::generator
