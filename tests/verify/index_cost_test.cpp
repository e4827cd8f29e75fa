// What a recolouring adds to 3 strips + swaps equals a recount on explicit triangles: the patch with a triangle beyond
// each port and, in turn, with every way in which its strip goes on there. Strips are followed from triangle to
// triangle; two turns go the same way exactly if they are around the same vertex. For every pair of colourings of
// small operations, and for the best rules of larger ones.

#include "judge/index_cost.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "definition/definition.hpp"
#include "model/description.hpp"

namespace restrip::verify::test {
namespace {

using Corners = std::array<int, 3>;
using Segment = std::pair<int, int>;

Segment segment(int a, int b) { return std::minmax(a, b); }

/// A side of an operation as triangles: which segments are its inner edges and its ports.
struct Drawn {
  std::vector<Corners> triangles;
  std::vector<Segment> edges;
  std::vector<Segment> ports;
};

/// The segment that two triangles share.
Segment shared(const Corners& one, const Corners& other) {
  std::vector<int> both;
  for (const int a : one)
    if (std::find(other.begin(), other.end(), a) != other.end()) both.push_back(a);
  return segment(both.at(0), both.at(1));
}

/// From the vertices that the file names.
Drawn drawn(const Side& side, const std::vector<PlacedTriangle>& placed) {
  Drawn all;
  for (const PlacedTriangle& one : placed)
    all.triangles.push_back(
        {static_cast<int>(one.vertex[0]), static_cast<int>(one.vertex[1]), static_cast<int>(one.vertex[2])});
  for (const auto& [one, other] : side.edges) all.edges.push_back(shared(all.triangles[one], all.triangles[other]));
  for (unsigned port = 0; port < side.ports(); ++port)
    for (const PlacedTriangle& one : placed)
      for (std::size_t s = 0; s < 3; ++s)
        if (one.side[s] == first_port_side + port)
          all.ports.push_back(segment(static_cast<int>(one.vertex[s]), static_cast<int>(one.vertex[(s + 1) % 3])));
  return all;
}

/// A fan around vertex 0 whose vertex splits in 0 and 1 where a triangle is inserted (-1 in `chain`; otherwise the
/// number of a triangle). Outer vertices from 2.
Drawn drawn_fan(const std::vector<int>& chain, int fan_triangles, bool ring) {
  Drawn all;
  all.triangles.resize(static_cast<std::size_t>(fan_triangles));
  const auto outer = [&](int i) { return 2 + (ring ? i % fan_triangles : i); };
  int hub = 0;
  int next = 0;
  std::vector<std::size_t> order;
  std::vector<std::size_t> inserted;
  for (const int element : chain) {
    if (element < 0) {
      order.push_back(all.triangles.size());
      inserted.push_back(order.back());
      all.triangles.push_back({0, 1, outer(next)});
      hub = 1 - hub;
      continue;
    }
    order.push_back(static_cast<std::size_t>(element));
    all.triangles[order.back()] = {hub, outer(element), outer(element + 1)};
    next = element + 1;
  }
  for (std::size_t i = 0; i + 1 < order.size(); ++i)
    all.edges.push_back(shared(all.triangles[order[i]], all.triangles[order[i + 1]]));
  if (ring) all.edges.push_back(shared(all.triangles[order.back()], all.triangles[order.front()]));
  if (inserted.size() == 2) all.edges.push_back({0, 1});
  for (int i = 0; i < fan_triangles; ++i) all.ports.push_back(segment(outer(i), outer(i + 1)));
  return all;
}

/// 3 strips + swaps of triangles that are joined across the solid segments.
int index_cost(const std::vector<Corners>& triangles, const std::set<Segment>& solid) {
  std::map<Segment, std::vector<std::size_t>> at;
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (std::size_t s = 0; s < 3; ++s) at[segment(triangles[t][s], triangles[t][(s + 1) % 3])].push_back(t);
  const auto solid_sides = [&](std::size_t t) {
    std::vector<Segment> sides;
    for (std::size_t s = 0; s < 3; ++s)
      if (const Segment one = segment(triangles[t][s], triangles[t][(s + 1) % 3]);
          solid.contains(one) && at[one].size() == 2)
        sides.push_back(one);
    return sides;
  };
  int cost = 0;
  std::set<std::size_t> met;
  for (std::size_t start = 0; start < triangles.size(); ++start) {
    if (met.contains(start) || solid_sides(start).size() == 2) continue;
    cost += 3;
    int last_pivot = -1;
    std::optional<Segment> entered;
    for (std::size_t t = start;;) {
      met.insert(t);
      std::optional<Segment> left;
      for (const Segment& side : solid_sides(t))
        if (side != entered) left = side;
      if (!left) break;
      if (entered) {
        const int pivot = left->first == entered->first || left->first == entered->second ? left->first : left->second;
        cost += pivot == last_pivot ? 1 : 0;
        last_pivot = pivot;
      }
      entered = left;
      t = at[*left][0] == t ? at[*left][1] : at[*left][0];
    }
  }
  return cost;
}

std::set<Segment> solid_in(const Drawn& side, Colors colors) {
  std::set<Segment> solid;
  for (unsigned e = 0; e < side.edges.size(); ++e)
    if (is_solid(colors.inner, e)) solid.insert(side.edges[e]);
  for (unsigned p = 0; p < side.ports.size(); ++p)
    if (is_solid(colors.ports, p)) solid.insert(side.ports[p]);
  return solid;
}

/// The most that is added, over every way on beyond the ports that are solid before.
int most_added(const Drawn& before, const Drawn& after, Colors old, Colors now) {
  std::vector<unsigned> solid_ports;
  for (unsigned p = 0; p < before.ports.size(); ++p)
    if (is_solid(old.ports, p)) solid_ports.push_back(p);
  int ways = 1;
  for (std::size_t i = 0; i < solid_ports.size(); ++i) ways *= 3;
  std::optional<int> most;
  for (int way = 0; way < ways; ++way) {
    std::vector<Corners> outside;
    std::set<Segment> beyond;
    int vertex = 100;
    int rest = way;
    for (const unsigned p : solid_ports) {
      const auto [a, b] = before.ports[p];
      const int apex = vertex++;
      const int left = vertex++;
      const int right = vertex++;
      outside.insert(outside.end(), {{a, b, apex}, {a, apex, left}, {b, apex, right}});
      if (rest % 3 == 1) beyond.insert(segment(a, apex));
      if (rest % 3 == 2) beyond.insert(segment(b, apex));
      rest /= 3;
    }
    const auto cost = [&](const Drawn& side, Colors colors) {
      std::vector<Corners> triangles = side.triangles;
      triangles.insert(triangles.end(), outside.begin(), outside.end());
      std::set<Segment> solid = solid_in(side, colors);
      solid.insert(beyond.begin(), beyond.end());
      return index_cost(triangles, solid);
    };
    const int added = cost(after, now) - cost(before, old);
    most = std::max(most.value_or(added), added);
  }
  return most.value();
}

std::vector<Colors> valid_colors(const Side& side) {
  std::vector<Colors> all;
  for (Mask both = 0; both < mask_count(side.colors()); ++both) {
    const Colors colors{high_part(both, side.ports()), low_part(both, side.ports())};
    if (valid_graph(side, colors, 2)) all.push_back(colors);
  }
  return all;
}

std::string in_words(const Operation& operation, Colors old, Colors now) {
  return fmt::format("{}: {:x} {:x} becomes {:x} {:x}", operation.name(), old.inner, old.ports, now.inner, now.ports);
}

void expect_every_pair(const Operation& operation, const Drawn& before, const Drawn& after) {
  const IndexCost cost(operation);
  for (const Colors old : valid_colors(operation.before))
    for (const Colors now : valid_colors(operation.after))
      if (is_subset(now.ports, old.ports)) {
        ASSERT_EQ(cost.added(old, now).by_rule, most_added(before, after, old, now)) << in_words(operation, old, now);
      }
}

Operation operation_of(const std::string& members) {
  return parse_operation(
      "f", "{\"restrip_operation\": 1, \"name\": \"index-own\", \"at_most\": [{\"indices\": 0}], " + members + "}");
}

TEST(IndexCost, SidesGivenByTriangles) {
  for (
      const std::string members :
      {R"("before": [["a", "b", "c"]], "after": [["a", "b", "m"], ["b", "c", "m"], ["m", "c", "a"]])",
       R"("after": [["c", "a", "b"]], "before": [["m", "a", "b"], ["m", "b", "c"], ["a", "m", "c"]])",
       R"("give_up": "all", "before": [["a", "b", "c"], ["c", "d", "a"]], "after": [["b", "d", "a"], ["d", "b", "c"]])",
       R"("before": [["a", "b", "c"], ["d", "c", "b"]], "boundary": [["c", "a"]],
           "after": [["a", "b", "m"], ["b", "d", "m"], ["d", "c", "m"]])",
       R"("before": [["p", "q", "r"], ["r", "q", "s"], ["r", "s", "t"]],
           "after": [["p", "q", "t"], ["q", "s", "t"], ["t", "r", "p"]])"}) {
    const Operation operation = operation_of(members);
    expect_every_pair(operation, drawn(operation.before, operation.placed_before),
                      drawn(operation.after, operation.placed_after));
  }
}

TEST(IndexCost, BestRulesOfLargerOperations) {
  // Red-green refinement of a triangle with its three neighbours; and its inverse.
  const std::string few = R"([["a", "b", "c"], ["b", "a", "z"], ["c", "b", "x"], ["a", "c", "y"]])";
  const std::string many = R"([["r", "p", "q"], ["p", "r", "a"], ["q", "p", "b"], ["r", "q", "c"], ["a", "z", "p"],
                               ["z", "b", "p"], ["b", "x", "q"], ["x", "c", "q"], ["c", "y", "r"], ["y", "a", "r"]])";
  const Operation operation = operation_of("\"before\": " + few + ", \"after\": " + many);
  const Drawn before = drawn(operation.before, operation.placed_before);
  const Drawn after = drawn(operation.after, operation.placed_after);
  const Definition definition(operation);
  const IndexCost cost(operation);
  for (const Colors old : valid_colors(operation.before)) {
    const Colors rule = definition.best(old).value().colors;
    ASSERT_EQ(cost.added(old, rule).by_rule, most_added(before, after, old, rule)) << in_words(operation, old, rule);
    ASSERT_EQ(cost.added(old, rule).at_most, cost.added(old, rule).by_rule);
  }
}

/// The chains of the shipped fans, in their words.
struct Chains {
  std::vector<int> fan;
  std::vector<int> with;
  bool ring = false;
};
Chains chains_of(const Operation& operation) {
  Chains chains;
  const int k = static_cast<int>(operation.ports());
  const std::vector<unsigned>& at = operation.numbers;
  chains.ring = at.size() == 2 && (operation.family == "split" || operation.family == "collapse");
  for (int i = 0; i < k; ++i) chains.fan.push_back(i);
  std::set<int> gaps{chains.ring ? 0 : static_cast<int>(at.at(1))};
  if (chains.ring) gaps.insert(static_cast<int>(at.at(1)));
  if (at.size() == 3) gaps.insert(static_cast<int>(at.at(2)));
  for (int i = 0; i <= k; ++i) {
    if (gaps.contains(i)) chains.with.push_back(-1);
    if (i < k) chains.with.push_back(i);
  }
  return chains;
}

TEST(IndexCost, Fans) {
  unsigned families = 0;
  for (const Family& family : all_families(3)) {
    for (const Section& section : family.sections)
      for (const Operation& operation : section.operations) {
        if (operation.numbers.empty()) continue;
        SCOPED_TRACE(operation.name());
        const Chains chains = chains_of(operation);
        const bool inserts = operation.before.triangles < operation.after.triangles;
        const int k = static_cast<int>(operation.ports());
        const Drawn fan = drawn_fan(chains.fan, k, chains.ring);
        const Drawn with = drawn_fan(chains.with, k, chains.ring);
        expect_every_pair(operation, inserts ? fan : with, inserts ? with : fan);

        // Colours passed on: an edge of the fan against the edges of the other chain between its two triangles.
        std::vector<Mask> through(fan.edges.size());
        std::map<int, std::size_t> place;
        for (std::size_t i = 0; i < chains.with.size(); ++i)
          if (chains.with[i] >= 0) place[chains.with[i]] = i;
        for (int e = 0; e < static_cast<int>(fan.edges.size()); ++e)
          if (k > 1)
            for (std::size_t i = place[e]; i != place[(e + 1) % k]; i = (i + 1) % chains.with.size())
              through[static_cast<std::size_t>(e)] |= single(static_cast<unsigned>(i));
        const IndexCost cost(operation);
        for (const Colors old : valid_colors(operation.before)) {
          Colors passed{0, old.ports};
          for (unsigned e = 0; e < through.size(); ++e) {
            if (inserts && is_solid(old.inner, e)) passed.inner |= through[e];
            if (!inserts && (old.inner & through[e]) == through[e]) passed.inner |= single(e);
          }
          // As a rule, the colours passed on are the cheaper ones of themselves; any other is at most as cheap.
          const int by_passed = cost.added(old, passed).by_rule;
          ASSERT_EQ(cost.added(old, passed).at_most, by_passed);
          const Colors other{0, old.ports};
          ASSERT_EQ(cost.added(old, other).at_most, std::min(by_passed, cost.added(old, other).by_rule));
        }
      }
    ++families;
  }
  EXPECT_GE(families, 4U);
}

TEST(IndexCost, Flip) {
  // Triangles L and R of the square 0 1 2 3, ports around it from 0 1.
  const std::vector<Segment> ports = {{0, 1}, {1, 2}, {2, 3}, {0, 3}};
  const Drawn before{{{0, 1, 2}, {2, 3, 0}}, {{0, 2}}, ports};
  const Drawn after{{{1, 2, 3}, {3, 0, 1}}, {{1, 3}}, ports};
  for (const Family& family : all_families(4))
    if (family.name == "flip") expect_every_pair(family.sections.at(0).operations.at(0), before, after);
}

}  // namespace
}  // namespace restrip::verify::test
