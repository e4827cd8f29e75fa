// Claims: what `restrip-verify explain` says of a recolouring is what trying every world and every recolouring says;
// a world that refutes it has the fewest connections of all that do; no edge of a set that shows why nothing is better
// can be left out, and each cheaper recolouring has one.
// The method shares nothing with the verifier: it is the method of naive_operation.hpp.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <map>
#include <random>
#include <set>

#include "explain/explanation.hpp"
#include "explain/rule_set.hpp"
#include "model/input.hpp"
#include "naive_operation.hpp"

namespace restrip::verify::test {
namespace {

NaiveColors naive(Colors colors) { return {static_cast<int>(colors.inner), static_cast<int>(colors.ports)}; }

Pairs pairs_of(const World& world) {
  Pairs pairs;
  for (const auto& set : world.connected)
    for (const unsigned i : set)
      for (const unsigned j : set)
        if (i < j) pairs.insert({static_cast<int>(i), static_cast<int>(j)});
  return pairs;
}

/// One for each port of a connected set but the smallest.
int connections(const Pairs& world) {
  std::set<int> ports;
  for (const Pair& pair : world) ports.insert(pair.second);
  return static_cast<int>(ports.size());
}

class ByTrial {
 public:
  explicit ByTrial(const Operation& operation) : naive_(operation) {}
  bool fits(bool after, Colors colors, const Pairs& world) const {
    return naive_.valid(after, naive(colors)) && naive_.fits(after, naive(colors), world);
  }
  bool possible(Colors configuration, const Pairs& world) const {
    return std::all_of(world.begin(), world.end(),
                       [&](const Pair& pair) {
                         return (configuration.ports >> pair.first & configuration.ports >> pair.second & 1U) != 0;
                       }) &&
           fits(false, configuration, world);
  }
  /// The fewest connections of a world that refutes it, or -1.
  int refuted(Colors configuration, Colors after) const {
    int fewest = -1;
    for (const Pairs& world : naive_.worlds(static_cast<int>(configuration.ports)))
      if ((fewest < 0 || connections(world) < fewest) && !fits(true, after, world) && possible(configuration, world))
        fewest = connections(world);
    return fewest;
  }
  std::vector<long> cost(Colors configuration, Colors after) const {
    return naive_.cost(naive(configuration), naive(after));
  }
  bool may_keep(Colors configuration, Mask kept) const {
    return naive_.may_keep(static_cast<int>(configuration.ports), static_cast<int>(kept));
  }
  /// Without the distinction between the best and those that are as good.
  Standing standing(Colors configuration, Colors after) const {
    if (!may_keep(configuration, after.ports)) return Standing::not_valid;
    const int refuted_by = refuted(configuration, after);
    if (refuted_by >= 0) return refuted_by == 0 ? Standing::not_valid : Standing::unsound;
    const auto own = cost(configuration, after);
    const auto sound = naive_.sound(naive(configuration));
    return std::any_of(sound.begin(), sound.end(), [&](const NaiveCandidate& other) { return other.cost < own; })
               ? Standing::worse
               : Standing::equally_good;
  }

 private:
  NaiveOperation naive_;
};

/// The obstacle breaks the constraint in its world, in which the configuration may stand, and without any of its edges
/// it does not.
void expect_obstacle(const ByTrial& trial, const Definition& definition, Colors configuration, const Obstacle& one) {
  const Operation& op = definition.operation();
  const Pairs world = pairs_of(definition.world(one.world));
  const Colors edges{one.edges.inner, one.edges.ports | one.ports};
  EXPECT_TRUE(trial.possible(configuration, world)) << text_of(definition, one);
  EXPECT_FALSE(trial.fits(true, edges, world)) << text_of(definition, one);
  EXPECT_EQ(one.ports & op.may_give_up, 0U);
  EXPECT_EQ(one.ports & ~configuration.ports, 0U);
  for (unsigned i = 0; i < 32; ++i) {
    const Mask bit = 1U << i;
    EXPECT_TRUE((edges.inner & bit) == 0 || trial.fits(true, {edges.inner ^ bit, edges.ports}, world));
    EXPECT_TRUE((edges.ports & bit) == 0 || trial.fits(true, {edges.inner, edges.ports ^ bit}, world));
  }
}

/// Shipped families at small positions, and operation files with the default cost.
std::vector<Operation> operations() {
  std::vector<Operation> all;
  for (const Description& one : shipped_descriptions())
    for (const Numbers& numbers : one.positions(5)) all.push_back(operation_at(one, numbers));
  const std::filesystem::directory_iterator files(RESTRIP_TABLES_DIR "/operations");
  for (const std::set<std::filesystem::path> sorted(begin(files), end(files)); const auto& file : sorted)
    all.push_back(parse_operation(file.string(), read_file(file.string())));
  std::erase_if(all, [](const Operation& one) { return one.cost != default_cost(one.constraint); });
  return all;
}

TEST(Explain, SaysWhatTryingEverythingSays) {
  const std::vector<Operation> all = operations();
  ASSERT_GT(all.size(), 60U);
  std::mt19937 random(45);
  std::map<Standing, int> seen;
  for (int round = 0; round < 250; ++round) {
    const Operation& op = all[static_cast<std::size_t>(round) % all.size()];
    const ByTrial trial(op);
    const Definition definition(op);
    const auto below = [&](unsigned bits) { return static_cast<Mask>(random() % (1U << bits)); };
    Colors configuration;
    do configuration = {below(op.before.inner_edges()), below(op.ports())};
    while (!trial.fits(false, configuration, {}));
    ASSERT_TRUE(definition.valid(configuration));
    for (int i = 0; i < 4; ++i) {
      Colors after{below(op.after.inner_edges()), configuration.ports};
      if (i % 2 == 0) after = definition.best(configuration)->colors;  // one edge or two from the best
      for (int flips = 0; i % 2 == 0 && flips < i && op.after.inner_edges() > 0; ++flips)
        after.inner ^= 1U << random() % op.after.inner_edges();
      if (i == 3) after.ports ^= below(op.ports()) & (configuration.ports | (below(op.ports()) & below(op.ports())));
      const Judgement judgement = judgement_of(definition, configuration, after);
      const Standing expected = trial.standing(configuration, after);
      ++seen[expected];
      ASSERT_EQ(std::min(judgement.standing, Standing::equally_good), expected)
          << op.name() << ' ' << arguments_of(op, configuration, after) << ": " << judgement.because;
      EXPECT_EQ(judgement.because.empty(), judgement.standing == Standing::best);
      if (!judgement.obstacle) continue;
      expect_obstacle(trial, definition, configuration, *judgement.obstacle);
      EXPECT_EQ(connections(pairs_of(definition.world(judgement.obstacle->world))),
                trial.refuted(configuration, after));
    }
    const Explanation explanation = explanation_of(definition, configuration);
    for (const Obstacle& obstacle : explanation.obstacles) expect_obstacle(trial, definition, configuration, obstacle);
    const auto least = trial.cost(configuration, explanation.best.value().colors);
    std::uint64_t cheaper = 0;
    std::uint64_t as_good_as_it = 0;
    for (Mask kept = 0; kept < 1U << op.ports(); ++kept)
      for (Mask inner = 0; inner < 1U << op.after.edges.size(); ++inner) {
        if (!trial.may_keep(configuration, kept)) continue;
        const Colors other{inner, kept};
        const auto cost = trial.cost(configuration, other);
        as_good_as_it += cost == least && trial.refuted(configuration, other) < 0 ? 1U : 0U;
        if (cost >= least) continue;
        ++cheaper;
        EXPECT_TRUE(std::any_of(explanation.obstacles.begin(), explanation.obstacles.end(), [&](const Obstacle& one) {
          return (one.edges.inner & ~other.inner) == 0 && (one.edges.ports & ~other.ports) == 0;
        }));
      }
    EXPECT_EQ(cheaper, explanation.cheaper);
    EXPECT_EQ(as_good_as_it, explanation.equally_good);
  }
  EXPECT_EQ(seen.size(), 4U);
  for (const auto& [standing, count] : seen) {
    std::cout << count << " x " << name_of(standing) << '\n';
    EXPECT_GT(count, 30);
  }
}

}  // namespace
}  // namespace restrip::verify::test
