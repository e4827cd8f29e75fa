// Claim: the rules of splits and collapses are best only among the recolourings that keep their ports
// (docs/explanation/theory.md, "Ports given up"). This is the example of that section, a split with k = 5 and a = 2,
// solved by the generator's search and by trying all recolourings on the ring with chord, numbered as in
// docs/reference/notation.md, in every outside.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <vector>

#include "../runtime/naive_patch.hpp"
#include "describe/description.hpp"
#include "solved.hpp"

namespace restrip::generator {
namespace {

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
