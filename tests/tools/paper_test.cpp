// Claims: the paper's policy isolates a triangle in about half of the splits, ours in none, and keeps strips valid; the
// drawn rules are all rules, each once up to symmetry; the lonely configurations are exactly those in which no
// recolouring keeps the passing strips whole without isolating a triangle.
#include "paper/paper.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>

#include "../runtime/fan_operation.hpp"
#include "folders.hpp"
#include "meshes/made_mesh.hpp"
#include "restrip/rules/key.hpp"
#include "shapes.hpp"

namespace restrip::tools {
namespace {

std::map<std::string, PolicyRun> runs_of(const PaperMesh& mesh) {
  std::map<std::string, PolicyRun> runs;
  for (const PolicyRun& run : mesh.runs) runs[run.name] = run;
  return runs;
}

TEST(Paper, IsolatesInHalfOfTheSplitsAndWeInNone) {
  const PaperMesh mesh = measure(simplified("torus", make_mesh(6000), {}));
  EXPECT_TRUE(mesh.faults.empty());
  const auto runs = runs_of(mesh);
  EXPECT_GT(runs.at("paper").isolating_percent(), 40);
  EXPECT_LT(runs.at("paper").isolating_percent(), 60);
  EXPECT_GT(runs.at("paper-alone").isolating_percent(), 80);
  for (const PolicyRun& run : mesh.runs) {
    EXPECT_EQ(run.splits, runs.at("local").splits) << run.name;
    EXPECT_EQ(run.levels.size(), 12U) << run.name;
    EXPECT_EQ(run.levels.back().triangles, mesh.triangles) << run.name;
    if (run.of_paper) continue;
    EXPECT_LT(run.levels.back().strips, runs.at("paper").levels.back().strips) << run.name;
    // Baking counts only strips, so it may isolate a triangle occasionally; the others promise not to.
    if (run.name == "baked") {
      EXPECT_LT(run.isolating_percent(), 1);
      continue;
    }
    EXPECT_EQ(run.isolating, 0U) << run.name;
    EXPECT_EQ(run.levels.back().isolated, 0U) << run.name;
  }
  // Tunnelling keeps isolated triangles below about a tenth of the strips.
  const Level& top = runs.at("paper-tunnel").levels.back();
  EXPECT_LE(top.isolated * 8, top.strips);
  EXPECT_EQ(std::accumulate(mesh.splits_by_valence.begin(), mesh.splits_by_valence.end(), std::size_t{0}),
            runs.at("local").splits);
  for (const PolicyRun& run : mesh.scratch) EXPECT_EQ(run.levels.back().triangles, mesh.triangles) << run.name;
}

TEST(Paper, BoundariesAreNoFault) {
  const PaperMesh mesh = measure(simplified("sheet", sheet(20), {}));
  EXPECT_TRUE(mesh.faults.empty());
  EXPECT_GT(mesh.runs.front().splits, 100U);
}

TEST(Paper, AMeshWithoutSplitsHasOneLevel) {
  const PaperMesh mesh = measure(simplified("tetrahedron", tetrahedron(), {}));
  EXPECT_TRUE(mesh.faults.empty());
  EXPECT_EQ(mesh.runs.front().splits, 0U);
  EXPECT_EQ(mesh.runs.front().isolating_percent(), 0);
}

TEST(Paper, BunnyIsThePapersAndItsPolicyLandsNearItsFigure) {
  const auto file = REAL_MESH("bunny.obj");
  const PaperMesh mesh = measure(source_of(read_mesh_file(file), file, {}, {}, false));
  EXPECT_TRUE(mesh.faults.empty());
  EXPECT_TRUE(mesh.equals_paper());
  EXPECT_NEAR(runs_of(mesh).at("paper").isolating_percent(), *mesh.paper->isolating_percent, 5);
  EXPECT_EQ(runs_of(mesh).at("local").isolating, 0U);
}

TEST(PaperRules, ReducedRulesCoverEveryConfiguration) {
  // Orbits of valid configurations and of loops: docs/explanation/theory.md, section 6.
  const std::map<std::size_t, std::pair<std::size_t, std::size_t>> known{{1, {88, 10}}, {2, {55, 9}}};
  for (const auto& [a, counts] : known) {
    const SplitPosition at{4, a};
    const auto rules = reduced_rules(at);
    EXPECT_EQ(rules.size(), counts.first) << a;
    EXPECT_EQ(loop_orbits(at), counts.second) << a;
    EXPECT_EQ(rules_with_full_ports(at).size(), counts.second - 1) << a;
    std::size_t covered = 0;
    for (const RuleOfOrbit& r : rules) covered += r.orbit;
    EXPECT_EQ(covered, 160U) << a;
  }
  EXPECT_EQ(reduced_rules({6, 3}).size(), 558U);
  EXPECT_EQ(reduced_rules({5, 2}).size(), 305U);
}

/// A split without a rule: colours are inherited; the new triangles join if both cut edges were dashed.
Word inherited(SplitPosition at, Word loop) {
  const bool at_a = has(loop, at.k - 1);
  const bool at_d = has(loop, at.a - 1);
  Word inner = 0;
  for (std::size_t j = 0; j < at.k + 2; ++j) {
    const bool of_a = j == 0 || j == at.k + 1;
    const bool of_d = j == at.a || j == at.a + 1;
    const std::size_t edge = j < at.a ? j - 1 : j - 2;
    if (of_a ? at_a : of_d ? at_d : has(loop, edge)) inner |= bit(j);
  }
  return at_a || at_d ? inner : inner | bit(at.k + 2);
}

TEST(PaperRules, LonelyConfigurations) {
  for (const SplitPosition& at : split_positions(6)) {
    const LonelyCount count = lonely_configurations(at);
    EXPECT_EQ(count.isolated, 0U);
    std::map<std::pair<Word, Word>, LonelyRule> listed;
    std::size_t covered = 0;
    for (const LonelyRule& one : count.orbits) {
      listed[{one.rule.loop, one.rule.ports}] = one;
      covered += one.rule.orbit;
    }
    EXPECT_EQ(covered, count.lonely);
    // The claim itself, by the library's definitions of validity and of joined ports.
    std::size_t valid = 0;
    std::size_t lonely = 0;
    for (Word loop = 0; loop < bit(at.k); ++loop) {
      for (Word ports = 0; ports < bit(at.k); ++ports) {
        if (!closed_fan(at.k).valid(loop, ports)) continue;
        ++valid;
        const Word joined = canonical_joined(ports, closed_fan(at.k).joined(loop, ports));
        const auto keeps = [&](Word inner) {
          return ring_with_chord(at.k, at.a).valid(inner, ports) &&
                 canonical_joined(ports, ring_with_chord(at.k, at.a).joined(inner, ports)) == joined;
        };
        const auto change = [&](Word inner) {
          return count_bits(detail::isolated_ring(at.k, at.a, inner, ports)) -
                 count_bits(detail::isolated_closed(at.k, loop, ports));
        };
        EXPECT_TRUE(keeps(inherited(at, loop)));
        int best = change(inherited(at, loop));
        for (Word inner = 0; inner < bit(at.k + 3); ++inner)
          if (change(inner) < best && keeps(inner)) best = change(inner);
        if (best > 0) ++lonely;
        const auto found = listed.find({loop, ports});
        if (found == listed.end()) continue;
        const LonelyRule& one = found->second;
        EXPECT_TRUE(keeps(one.whole));
        EXPECT_EQ(change(one.whole), one.isolated_if_whole);
        EXPECT_EQ(best, one.isolated_if_whole);
        EXPECT_FALSE(keeps(one.rule.inner)) << "a passing strip is cut";
        EXPECT_LE(change(one.rule.inner), 0);
        EXPECT_GE(count_bits(one.rule.inner), count_bits(one.whole)) << "and no strip lost by that";
      }
    }
    EXPECT_EQ(lonely, count.lonely);
    EXPECT_EQ(valid, count.valid);
  }
}

TEST(PaperRules, TheConfigurationOfFigure8) {
  // Three strips pass through a 6-vertex, two triangles of each; one split edge lies inside a strip, one between two.
  const LonelyCount count = lonely_configurations({6, 3});
  EXPECT_TRUE(std::any_of(count.orbits.begin(), count.orbits.end(), [](const LonelyRule& one) {
    return one.rule.loop == 0b010101 && one.rule.ports == 0b111111;
  }));
}

}  // namespace
}  // namespace restrip::tools
