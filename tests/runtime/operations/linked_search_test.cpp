// Linked rules beyond the tables, and of open fans: sound in every world, and none that is sound is
// better. The judges are every recolouring, the tables, and a search on the explicit graph (outside_frontier.hpp); at
// operations on meshes, that graph is made of the mesh's triangles, and reported changes are counted again.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <iostream>
#include <random>
#include <string>
#include <vector>

#include "naive_patch.hpp"
#include "outside_frontier.hpp"
#include "restrip/mesh/checks.hpp"
#include "restrip/operations/linked.hpp"
#include "restrip/output/strips.hpp"
#include "sample_meshes.hpp"

namespace restrip {
namespace {

using naive::OutsideFrontier;

enum class LinkedFamily { split, collapse, open_split, open_collapse, boundary_split, boundary_collapse };

/// A random patch with random valid colours, and what there is outside.
struct LinkedInstance {
  LinkedFamily family{};
  std::size_t k = 0;
  std::size_t a = 0;
  std::size_t i = 0;
  std::size_t j = 0;
  Word ports = 0;
  Word colors = 0;
  std::vector<int> seen;  ///< what a look outward says of each port

  naive::Patch patch(bool of_split) const {
    if (family == LinkedFamily::split || family == LinkedFamily::collapse)
      return of_split ? naive::closed_fan(k) : naive::ring_with_chord(k, a);
    if (of_split) return naive::open_fan(k);
    return family == LinkedFamily::open_collapse || family == LinkedFamily::open_split ? naive::path_with_chord(k, i, j)
                                                                                       : naive::path(k, i);
  }
  bool splits() const {
    return family == LinkedFamily::split || family == LinkedFamily::open_split ||
           family == LinkedFamily::boundary_split;
  }
  naive::Patch before() const { return patch(splits()); }
  naive::Patch after() const { return patch(!splits()); }
  naive::Bits port_bits() const { return naive::bits_of(ports, k); }
  /// Ports that colours inside the patch join.
  naive::UnionFind paths_inside() const {
    naive::UnionFind paths(k);
    const naive::Patch patch = before();
    for (const auto& [x, y] : naive::analyze(patch, naive::bits_of(colors, patch.edges.size()), port_bits()).joined)
      paths.unite(x, y);
    return paths;
  }
  /// For splits and collapses, where the rule is from tables if the fan is small.
  Rule searched() const {
    const auto look = [this](std::size_t port) { return seen[port]; };
    const detail::Layout fan = detail::closed_fan(k);
    const detail::Layout ring = detail::ring_with_chord(k, a);
    return detail::searched_rule(splits() ? fan : ring, colors, splits() ? ring : fan, ports, look);
  }

  Rule rule(bool linked) const {
    const auto look = [this](std::size_t port) { return seen[port]; };
    const detail::Layout open = detail::open_fan(k);
    if (family == LinkedFamily::split)
      return linked ? linked_split_rule({k, a}, colors, ports, look) : split_rule({k, a}, colors, ports);
    if (family == LinkedFamily::collapse)
      return linked ? linked_collapse_rule({k, a}, colors, ports, look) : collapse_rule({k, a}, colors, ports);
    const bool chord = family == LinkedFamily::open_split || family == LinkedFamily::open_collapse;
    const detail::Layout divided = chord ? detail::path_with_chord(k, i, j) : detail::path(k, i);
    if (linked) return detail::searched_rule(splits() ? open : divided, colors, splits() ? divided : open, ports, look);
    if (family == LinkedFamily::open_split) return open_split_rule({k, i, j}, colors, ports);
    if (family == LinkedFamily::open_collapse) return open_collapse_rule({k, i, j}, colors, ports);
    return splits() ? boundary_split_rule({k, i}, colors, ports) : boundary_collapse_rule({k, i}, colors, ports);
  }
};

/// Adds solid edges in random order while the colours stay valid. (Whether they are is found along the row of nodes, by
/// degrees and union-find.)
Word random_colors(std::mt19937_64& random, const naive::Patch& patch, const naive::Bits& ports) {
  std::vector<std::size_t> order(patch.edges.size());
  for (std::size_t e = 0; e < order.size(); ++e) order[e] = e;
  std::shuffle(order.begin(), order.end(), random);
  std::vector<int> degree(patch.nodes, 0);
  for (std::size_t p = 0; p < ports.size(); ++p) degree[patch.port_node[p]] += ports[p] ? 1 : 0;
  naive::UnionFind strands(patch.nodes);
  Word colors = 0;
  for (const std::size_t e : order) {
    const auto [u, v] = patch.edges[e];
    if (random() % 12 == 0 || degree[u] == 2 || degree[v] == 2 || !strands.unite(u, v)) continue;
    ++degree[u];
    ++degree[v];
    colors |= bit(e);
  }
  return colors;
}

/// Joins up to `pairs` pairs of ports outside, so that no cycle closes, and hides a few ports.
LinkedInstance random_linked(std::mt19937_64& random, LinkedFamily family, std::size_t k, std::size_t pairs,
                             std::size_t hidden) {
  LinkedInstance result;
  result.family = family;
  result.k = k;
  result.a = 1 + random() % (k - 1);
  result.i = random() % 4 == 0 ? 0 : random() % k;
  result.j = random() % 4 == 0 ? k : result.i + 1 + random() % (k - result.i);
  const std::uint64_t density = 1 + random() % 7;
  for (std::size_t p = 0; p < k; ++p)
    if (random() % 8 < density) result.ports |= bit(p);
  result.colors = random_colors(random, result.before(), result.port_bits());
  result.seen.assign(k, strip_ends);
  naive::UnionFind paths = result.paths_inside();
  std::vector<std::size_t> solid;
  for (std::size_t p = 0; p < k; ++p)
    if (has(result.ports, p)) solid.push_back(p);
  // Near ports more often than far ones.
  std::shuffle(solid.begin(), solid.end(), random);
  if (random() % 2 == 0) std::sort(solid.begin(), solid.end(), [&](auto x, auto y) { return x / 4 < y / 4; });
  for (std::size_t n = 0; n + 1 < solid.size() && pairs > 0; n += 2) {
    if (random() % 5 == 0 || !paths.unite(solid[n], solid[n + 1])) continue;
    result.seen[solid[n]] = static_cast<int>(solid[n + 1]);
    result.seen[solid[n + 1]] = static_cast<int>(solid[n]);
    --pairs;
  }
  for (; hidden > 0 && !solid.empty(); --hidden) {
    const std::size_t p = solid[random() % solid.size()];
    if (result.seen[p] >= 0) result.seen[static_cast<std::size_t>(result.seen[p])] = out_of_sight;
    result.seen[p] = out_of_sight;
  }
  return result;
}

/// Of two ports out of sight: did a path inside and outside lead from one to the other before? Then it leads nowhere
/// else, and they may be joined.
std::function<bool(int, int)> joined_before(const LinkedInstance& instance, bool blind) {
  naive::UnionFind paths = instance.paths_inside();
  for (std::size_t p = 0; p < instance.k; ++p)
    if (!blind && instance.seen[p] >= 0) paths.unite(p, static_cast<std::size_t>(instance.seen[p]));
  return [paths](int x, int y) {
    return paths.find(static_cast<std::size_t>(x)) == paths.find(static_cast<std::size_t>(y));
  };
}

OutsideFrontier frontier_of(const LinkedInstance& instance, bool blind) {
  const naive::Patch after = instance.after();
  OutsideFrontier graph(static_cast<int>(after.nodes));
  for (const auto& [u, v] : after.edges) graph.add_edge(static_cast<int>(u), static_cast<int>(v));
  for (std::size_t p = 0; p < instance.k; ++p) {
    if (!has(instance.ports, p)) continue;
    const int node = static_cast<int>(after.port_node[p]);
    const int seen = blind ? out_of_sight : instance.seen[p];
    if (seen == out_of_sight) graph.add_hidden(node, static_cast<int>(p));
    if (seen == strip_ends) graph.add_end(node);
    if (seen > static_cast<int>(p))
      graph.add_strip(node, static_cast<int>(after.port_node[static_cast<std::size_t>(seen)]));
  }
  return graph;
}

/// The value of a recolouring, or -1 if it is not sound with what is seen. Paths are followed on a graph of ports.
long value_beside(const LinkedInstance& instance, Word colors, bool blind) {
  const naive::Patch after = instance.after();
  const naive::Analysis found = naive::analyze(after, naive::bits_of(colors, after.edges.size()), instance.port_bits());
  if (!found.valid || (colors & ~low_bits(after.edges.size())) != 0) return -1;
  naive::UnionFind paths(instance.k);
  for (const auto& [x, y] : found.joined) paths.unite(x, y);
  const auto hidden = [&](std::size_t p) { return blind || instance.seen[p] == out_of_sight; };
  for (std::size_t p = 0; p < instance.k; ++p)
    if (!hidden(p) && instance.seen[p] > static_cast<int>(p) &&
        !paths.unite(p, static_cast<std::size_t>(instance.seen[p])))
      return -1;
  const auto may_join = joined_before(instance, blind);
  for (std::size_t x = 0; x < instance.k; ++x)
    for (std::size_t y = x + 1; y < instance.k; ++y)
      if (has(instance.ports, x) && has(instance.ports, y) && hidden(x) && hidden(y) &&
          paths.find(x) == paths.find(y) && !may_join(static_cast<int>(x), static_cast<int>(y)))
        return -1;
  return found.value();
}

constexpr LinkedFamily linked_families[] = {LinkedFamily::split,          LinkedFamily::collapse,
                                            LinkedFamily::open_split,     LinkedFamily::open_collapse,
                                            LinkedFamily::boundary_split, LinkedFamily::boundary_collapse};

/// Rules and linked rules against the frontier; returns the number of times that the linked rule keeps more strips
/// together.
int check_linked(std::uint64_t seed, int runs, std::size_t from, std::size_t to) {
  std::mt19937_64 random(seed);
  int bolder = 0;
  for (int run = 0; run < runs; ++run)
    for (const LinkedFamily family : linked_families) {
      const std::size_t k = from + random() % (to - from + 1);
      const LinkedInstance instance = random_linked(random, family, k, random() % 6, random() % 4);
      SCOPED_TRACE("seed " + std::to_string(seed) + " run " + std::to_string(run) + " family " +
                   std::to_string(static_cast<int>(family)) + " k " + std::to_string(k));
      long value[2];
      for (const bool linked : {false, true}) {
        const Rule rule = instance.rule(linked);
        EXPECT_TRUE(rule.valid);
        value[linked ? 1 : 0] = value_beside(instance, rule.colors, !linked);
        EXPECT_GE(value[linked ? 1 : 0], 0) << "not sound";
        const naive::Patch after = instance.after();
        EXPECT_EQ(rule.strips, static_cast<int>(after.nodes) - static_cast<int>(instance.before().nodes) -
                                   (count_bits(rule.colors) - count_bits(instance.colors)));
        EXPECT_EQ(value[linked ? 1 : 0], frontier_of(instance, !linked).best(joined_before(instance, !linked)))
            << (linked ? "linked" : "local");
      }
      bolder += value[1] / 500'000 > value[0] / 500'000 ? 1 : 0;
      if (family == LinkedFamily::split || family == LinkedFamily::collapse) {
        EXPECT_EQ(value_beside(instance, instance.searched().colors, false), value[1]);
      }
      if (::testing::Test::HasFailure()) return bolder;
    }
  std::cout << runs << " patches of each operation, k = " << from << " ... " << to << '\n';
  return bolder;
}

TEST(LinkedSearch, IsBestByTheFrontierInSmallFans) { EXPECT_GT(check_linked(20260201, 500, 3, 12), 100); }

TEST(LinkedSearch, IsBestByTheFrontierInLargerFans) { EXPECT_GT(check_linked(20260202, 60, 9, 30), 50); }

TEST(LinkedSearch, IsBestByTheFrontierUpToTheWordSize) { EXPECT_GT(check_linked(20260203, 20, 50, 61), 20); }

// No recolouring is better, by exhaustion and by the frontier.
TEST(LinkedSearch, IsBestOfAllRecolorings) {
  std::mt19937_64 random(20260204);
  for (int run = 0; run < 44; ++run)
    for (const LinkedFamily family : linked_families) {
      const std::size_t k = run < 20 ? 3 + random() % 6 : 9 + random() % 4;
      const LinkedInstance instance = random_linked(random, family, k, random() % 5, random() % 4);
      SCOPED_TRACE("run " + std::to_string(run) + " family " + std::to_string(static_cast<int>(family)));
      long best = -1;
      for (Word colors = 0; colors < bit(instance.after().edges.size()); ++colors)
        if (best < 0 || count_bits(colors) * 1'000'000L >= best)
          best = std::max(best, value_beside(instance, colors, false));
      EXPECT_EQ(value_beside(instance, instance.rule(true).colors, false), best);
      EXPECT_EQ(frontier_of(instance, false).best(joined_before(instance, false)), best);
    }
}

/// Fans in which the limit on answers is met: then, too, the answer is sound and no worse than the rule.
TEST(LinkedSearch, GivesUpSoundly) {
  std::mt19937_64 random(20260208);
  int given_up = 0;
  int bolder = 0;
  for (int run = 0; run < 12000; ++run) {
    const LinkedInstance instance = random_linked(random, LinkedFamily::split, 61, 30, random() % 4);
    const auto look = [&](std::size_t port) { return instance.seen[port]; };
    detail::LinkedSearch search(detail::ring_with_chord(61, instance.a), instance.ports,
                                detail::inner_pairs(detail::closed_fan(61), instance.colors, instance.ports), look);
    const Word colors = search.best();
    if (!search.gave_up()) continue;
    ++given_up;
    const long local = value_beside(instance, instance.rule(false).colors, true);
    EXPECT_EQ(instance.rule(true).colors, colors);
    EXPECT_GE(value_beside(instance, colors, false), local);
    bolder += value_beside(instance, colors, false) > local ? 1 : 0;
  }
  EXPECT_GT(given_up, 10);
  EXPECT_GT(bolder, 5);
}

}  // namespace
}  // namespace restrip
