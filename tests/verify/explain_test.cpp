// Claims: what `restrip-verify explain` says of a recolouring is what trying every world and every recolouring says;
// a world that refutes it has the fewest connections of all that do; no edge of a set that shows why nothing is better
// can be left out, and each cheaper recolouring has one; and on the mesh around a split, its solid cycle is there.
// The method shares nothing with the verifier: patches by themselves, a union-find over worlds that are listed here.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <functional>
#include <iostream>
#include <numeric>
#include <random>
#include <restrip/restrip.hpp>

#include "explain/explanation.hpp"
#include "explain/rule_set.hpp"
#include "model/input.hpp"

namespace restrip::verify::test {
namespace {

using Sets = std::vector<std::vector<int>>;
enum Said { not_valid, unsound, worse, as_good };

class Forest {
 public:
  explicit Forest(int nodes) : parent_(static_cast<std::size_t>(nodes)) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }
  bool join(int a, int b) {
    a = root(a);
    b = root(b);
    parent_[static_cast<std::size_t>(a)] = b;
    return a != b;
  }

 private:
  int root(int node) const {
    while (parent_[static_cast<std::size_t>(node)] != node) node = parent_[static_cast<std::size_t>(node)];
    return node;
  }
  std::vector<int> parent_;
};

/// Calls back with every way to put ports, from `next` on, into sets of at most `most` (one: alone).
void each_world(int ports, int next, std::size_t most, Sets& sets, const std::function<void(const Sets&)>& visit) {
  if (next == ports) return visit(sets);
  for (std::size_t i = 0; i <= sets.size(); ++i) {
    if (i == sets.size())
      sets.push_back({next});
    else if (sets[i].size() < most)
      sets[i].push_back(next);
    else
      continue;
    each_world(ports, next + 1, most, sets, visit);
    sets[i].pop_back();
    if (sets[i].empty()) sets.pop_back();
  }
}

int connections(const Sets& world) {
  int count = 0;
  for (const auto& set : world) count += static_cast<int>(set.size()) - 1;
  return count;
}

class ByTrial {
 public:
  explicit ByTrial(const Operation& operation) : op_(operation) {
    const bool strips = operation.constraint == Constraint::strips;
    const std::size_t most = strips ? 2 : operation.constraint == Constraint::forest ? 99 : 1;
    Sets sets;
    each_world(static_cast<int>(operation.ports()), 0, most, sets,
               [&](const Sets& world) { worlds_.push_back(world); });
    std::stable_sort(worlds_.begin(), worlds_.end(),
                     [](const Sets& a, const Sets& b) { return connections(a) < connections(b); });
    most_solid_ = strips ? 2 : operation.constraint == Constraint::forest ? 3 : 1;
  }
  bool fits(const Side& side, Colors colors, const Sets& world) const {
    std::vector<int> degree(side.triangles);
    const int first = static_cast<int>(side.triangles);
    Forest forest(first + static_cast<int>(side.ports()));
    bool good = true;
    for (std::size_t i = 0; i < side.edges.size(); ++i) {
      if ((colors.inner >> i & 1U) == 0) continue;
      ++degree[side.edges[i][0]];
      ++degree[side.edges[i][1]];
      good = forest.join(static_cast<int>(side.edges[i][0]), static_cast<int>(side.edges[i][1])) && good;
    }
    for (std::size_t i = 0; i < side.owner_of_port.size(); ++i) {
      if ((colors.ports >> i & 1U) == 0) continue;
      ++degree[side.owner_of_port[i]];
      good = forest.join(static_cast<int>(side.owner_of_port[i]), first + static_cast<int>(i)) && good;
    }
    for (const auto& set : world)
      for (std::size_t i = 1; i < set.size(); ++i) good = forest.join(first + set[0], first + set[i]) && good;
    return good && *std::max_element(degree.begin(), degree.end()) <= most_solid_;
  }
  bool possible(Colors configuration, const Sets& world) const {
    for (const auto& set : world)
      for (const int port : set)
        if (set.size() > 1 && (configuration.ports >> port & 1U) == 0) return false;
    return fits(op_.before, configuration, world);
  }
  /// The fewest connections of a world that refutes it, or -1.
  int refuted(Colors configuration, Colors after) const {
    for (const Sets& world : worlds_)
      if (!fits(op_.after, after, world) && possible(configuration, world)) return connections(world);
    return -1;
  }
  bool ports_right(Colors configuration, Colors after) const {
    return (after.ports & ~configuration.ports) == 0 && (configuration.ports & ~after.ports & ~op_.may_give_up) == 0;
  }
  std::array<int, 3> cost(Colors configuration, Colors after) const {
    std::vector<int> degree(op_.after.triangles);
    for (std::size_t i = 0; i < op_.after.edges.size(); ++i)
      for (const unsigned t : op_.after.edges[i]) degree[t] += static_cast<int>(after.inner >> i & 1U);
    for (std::size_t i = 0; i < op_.after.owner_of_port.size(); ++i)
      degree[op_.after.owner_of_port[i]] += static_cast<int>(after.ports >> i & 1U);
    const int given_up = std::popcount(configuration.ports & ~after.ports);
    const int strips = -std::popcount(after.inner) - std::popcount(after.ports);
    return {op_.constraint == Constraint::matching ? 0 : strips,
            static_cast<int>(std::count(degree.begin(), degree.end(), 0)) + given_up, given_up};
  }
  template <class Visit>
  void each_recolouring(Colors configuration, const Visit& visit) const {
    for (Mask kept = 0; kept < 1U << op_.ports(); ++kept)
      for (Mask inner = 0; inner < 1U << op_.after.edges.size(); ++inner)
        if (ports_right(configuration, {inner, kept})) visit(Colors{inner, kept});
  }
  Said says(Colors configuration, Colors after) const {
    if (!ports_right(configuration, after)) return not_valid;
    const int refuted_by = refuted(configuration, after);
    if (refuted_by >= 0) return refuted_by == 0 ? not_valid : unsound;
    bool better = false;
    each_recolouring(configuration, [&](Colors other) {
      better = better || (cost(configuration, other) < cost(configuration, after) && refuted(configuration, other) < 0);
    });
    return better ? worse : as_good;
  }

 private:
  const Operation& op_;
  std::vector<Sets> worlds_;
  int most_solid_ = 2;
};

Sets sets_of(const World& world) {
  Sets sets;
  for (const auto& set : world.connected) sets.emplace_back(set.begin(), set.end());
  return sets;
}

Said said_of(Standing standing) {
  return standing == Standing::not_valid ? not_valid
         : standing == Standing::unsound ? unsound
         : standing == Standing::worse   ? worse
                                         : as_good;
}

/// The obstacle breaks the constraint in its world, in which the configuration may stand, and without any of its edges
/// it does not.
void expect_obstacle(const ByTrial& trial, const Definition& definition, Colors configuration, const Obstacle& one) {
  const Operation& op = definition.operation();
  const Sets world = sets_of(definition.world(one.world));
  const Colors edges{one.edges.inner, one.edges.ports | one.ports};
  EXPECT_TRUE(trial.possible(configuration, world)) << text_of(definition, one);
  EXPECT_FALSE(trial.fits(op.after, edges, world)) << text_of(definition, one);
  EXPECT_EQ(one.ports & op.may_give_up, 0U);
  EXPECT_EQ(one.ports & ~configuration.ports, 0U);
  for (unsigned i = 0; i < 32; ++i) {
    const Mask bit = 1U << i;
    EXPECT_TRUE((edges.inner & bit) == 0 || trial.fits(op.after, {edges.inner ^ bit, edges.ports}, world));
    EXPECT_TRUE((edges.ports & bit) == 0 || trial.fits(op.after, {edges.inner, edges.ports ^ bit}, world));
  }
}

Operation shipped(const std::string& name, const Numbers& numbers) {
  for (const Description& one : shipped_descriptions())
    if (one.name == name) return operation_at(one, numbers);
  throw std::logic_error(name);
}

/// Shipped families at small positions, and operation files with the default cost.
std::vector<Operation> operations() {
  std::vector<Operation> all;
  for (const Description& one : shipped_descriptions())
    for (const Numbers& numbers : one.positions(5)) all.push_back(operation_at(one, numbers));
  for (const char* name : {"bisect", "bisect-boundary", "bisect-matching", "flip-matching", "join-faces", "merge",
                           "merge-matching", "split-face"}) {
    const std::string path = fmt::format("{}/operations/{}.json", RESTRIP_TABLES_DIR, name);
    all.push_back(parse_operation(path, read_file(path)));
  }
  std::erase_if(all, [](const Operation& one) { return one.cost != default_cost(one.constraint); });
  return all;
}

TEST(Explain, SaysWhatTryingEverythingSays) {
  const std::vector<Operation> all = operations();
  ASSERT_GT(all.size(), 60U);
  std::mt19937 random(45);
  std::array<int, 4> seen{};
  for (int round = 0; round < 250; ++round) {
    const Operation& op = all[static_cast<std::size_t>(round) % all.size()];
    const ByTrial trial(op);
    const Definition definition(op);
    const auto below = [&](unsigned bits) { return static_cast<Mask>(random() % (1U << bits)); };
    Colors configuration;
    do configuration = {below(op.before.inner_edges()), below(op.ports())};
    while (!trial.fits(op.before, configuration, {}));
    ASSERT_TRUE(definition.valid(configuration));
    for (int i = 0; i < 4; ++i) {
      Colors after{below(op.after.inner_edges()), configuration.ports};
      if (i % 2 == 0) after = definition.best(configuration)->colors;  // one edge or two from the best
      for (int flips = 0; i % 2 == 0 && flips < i && op.after.inner_edges() > 0; ++flips)
        after.inner ^= 1U << random() % op.after.inner_edges();
      if (i == 3) after.ports ^= below(op.ports()) & (configuration.ports | (below(op.ports()) & below(op.ports())));
      const Judgement judgement = judgement_of(definition, configuration, after);
      const Said expected = trial.says(configuration, after);
      ++seen[expected];
      ASSERT_EQ(said_of(judgement.standing), expected)
          << op.name() << ' ' << arguments_of(op, configuration, after) << ": " << judgement.because;
      EXPECT_EQ(judgement.because.empty(), judgement.standing == Standing::best);
      if (!judgement.obstacle) continue;
      expect_obstacle(trial, definition, configuration, *judgement.obstacle);
      EXPECT_EQ(connections(sets_of(definition.world(judgement.obstacle->world))), trial.refuted(configuration, after));
    }
    const Explanation explanation = explanation_of(definition, configuration);
    for (const Obstacle& obstacle : explanation.obstacles) expect_obstacle(trial, definition, configuration, obstacle);
    const auto least = trial.cost(configuration, explanation.best.value().colors);
    std::uint64_t cheaper = 0;
    std::uint64_t as_good_as_it = 0;
    trial.each_recolouring(configuration, [&](Colors other) {
      const auto cost = trial.cost(configuration, other);
      as_good_as_it += cost == least && trial.refuted(configuration, other) < 0 ? 1U : 0U;
      if (cost >= least) return;
      ++cheaper;
      EXPECT_TRUE(std::any_of(explanation.obstacles.begin(), explanation.obstacles.end(), [&](const Obstacle& one) {
        return (one.edges.inner & ~other.inner) == 0 && (one.edges.ports & ~other.ports) == 0;
      }));
    });
    EXPECT_EQ(cheaper, explanation.cheaper);
    EXPECT_EQ(as_good_as_it, explanation.equally_good);
  }
  for (const int count : seen) EXPECT_GT(count, 30);
  std::cout << "not valid, unsound, worse, as good: " << seen[0] << ' ' << seen[1] << ' ' << seen[2] << ' ' << seen[3]
            << '\n';
}

/// A vertex of k triangles before and after its split at (k, a), in two rings of 2k triangles. Triangles: t_i, then the
/// rings, in each two behind each port, then A and D. What is connected outside is connected through the outer ring.
StripMesh mesh_around(unsigned k, unsigned a, bool after, Colors colors, const std::vector<unsigned>& outside) {
  std::vector<std::uint32_t> indices;
  const auto add = [&](std::uint32_t u, std::uint32_t v, std::uint32_t w) { indices.insert(indices.end(), {u, v, w}); };
  const auto inner = [&](unsigned i) { return 2 + i % k; };
  const auto outer = [&](unsigned i) { return 2 + k + i % k; };
  const auto far = [&](unsigned i) { return 2 + 2 * k + i % k; };
  for (unsigned i = 0; i < k; ++i) add(after && i >= a ? 1 : 0, inner(i), inner(i + 1));
  for (unsigned i = 0; i < k; ++i) {
    add(inner(i + 1), inner(i), outer(i));
    add(inner(i + 1), outer(i), outer(i + 1));
  }
  for (unsigned i = 0; i < k; ++i) {
    add(outer(i + 1), outer(i), far(i));
    add(outer(i + 1), far(i), far(i + 1));
  }
  if (after) {
    add(inner(0), 0, 1);
    add(inner(a), 1, 0);
  }
  StripMesh mesh = StripMesh::build(indices, 2 + 3 * k);
  const auto set = [&](unsigned one, unsigned other) {
    for (unsigned side = 0; side < 3; ++side) {
      const auto h = StripMesh::halfedge(one, side);
      const auto back = mesh.opposite(h);
      if (!StripMesh::on_boundary(back) && StripMesh::triangle(back) == other) return mesh.set_solid(h, true);
    }
    FAIL() << one << " and " << other << " share no edge";
  };
  const unsigned first_new = 5 * k;
  const Side side = shipped("split", {k, a}).after;  // triangles k and k + 1 are A and D
  const Side fan = shipped("split", {k, a}).before;
  const auto& edges = after ? side.edges : fan.edges;
  const auto number = [&](unsigned triangle) { return triangle < k ? triangle : first_new + triangle - k; };
  for (std::size_t i = 0; i < edges.size(); ++i)
    if ((colors.inner >> i & 1U) != 0) set(number(edges[i][0]), number(edges[i][1]));
  for (unsigned i = 0; i < k; ++i)
    if ((colors.ports >> i & 1U) != 0) set(i, k + 2 * i);
  for (const unsigned port : outside) {
    set(k + 2 * port, k + 2 * port + 1);
    set(k + 2 * port + 1, 3 * k + 2 * port);
  }
  for (unsigned at = 3 * k + 2 * outside[0]; at != 3 * k + 2 * outside[1]; ++at) set(at, at + 1);
  return mesh;
}

TEST(Explain, TheCycleIsThereOnAMesh) {
  std::mt19937 random(4);
  int found = 0;
  for (unsigned k = 3; k <= 6; ++k)
    for (unsigned a = 1; 2 * a <= k; ++a) {
      const Operation op = shipped("split", {k, a});
      const Definition definition(op);
      for (int tries = 0; tries < 3000; ++tries) {
        const Colors configuration{static_cast<Mask>(random() % (1U << k)), static_cast<Mask>(random() % (1U << k))};
        const Colors after{static_cast<Mask>(random() % (1U << (k + 3))), configuration.ports};
        if (!definition.valid(configuration)) continue;
        const Judgement judgement = judgement_of(definition, configuration, after);
        if (judgement.standing != Standing::unsound) continue;
        const World& world = definition.world(judgement.obstacle->world);
        ASSERT_EQ(world.connected.size(), 1U);
        EXPECT_TRUE(check_coloring(mesh_around(k, a, false, configuration, world.connected[0])).valid);
        const StripMesh mesh = mesh_around(k, a, true, after, world.connected[0]);
        EXPECT_FALSE(check_coloring(mesh).valid);
        for (std::uint32_t t = 0; t < 5 * k + 2; ++t) EXPECT_LE(mesh.solid_degree(t), 2U);  // so it is a cycle
        ++found;
      }
    }
  EXPECT_GT(found, 100);
}

}  // namespace
}  // namespace restrip::verify::test
