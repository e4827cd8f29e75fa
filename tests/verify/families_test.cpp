// The families of tables/families.json are those of docs/notation.md: every position of fans up to ten triangles is
// there, listed or not as that page says, and its patches are those that the tests write down by hand. Files that say
// something else than a family are refused with their line.

#include <gtest/gtest.h>

#include <boost/graph/iteration_macros.hpp>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "family_file.hpp"
#include "input.hpp"
#include "naive_tables.hpp"
#include "operation.hpp"

namespace restrip::verify::test {
namespace {

std::string name_of_triangle(int triangle) {
  if (triangle == triangle_a) return "A";
  if (triangle == triangle_d) return "D";
  return "t" + std::to_string(triangle);
}

void expect_same(const Patch& patch, const NaivePatch& naive, const std::string& where) {
  const DualGraph& graph = patch.graph();
  EXPECT_EQ(patch.closed(), naive.closed) << where;
  EXPECT_EQ(patch.chord() ? static_cast<int>(*patch.chord()) : -1, naive.chord) << where;
  ASSERT_EQ(patch.ports(), naive.port_owner.size()) << where;
  ASSERT_EQ(patch.inner_edges(), naive.edges.size()) << where;
  std::vector<std::string> triangles;
  for (const Node node : patch.triangles()) triangles.push_back(graph[node].name);
  std::vector<std::string> expected;
  for (const int triangle : naive.triangles) expected.push_back(name_of_triangle(triangle));
  EXPECT_EQ(triangles, expected) << where;
  for (unsigned port = 0; port < patch.ports(); ++port)
    EXPECT_EQ(graph[patch.owner_of_port(port)].name, name_of_triangle(naive.port_owner[port])) << where;
  BGL_FORALL_EDGES(edge, graph, DualGraph) {
    if (graph[edge].kind != EdgeKind::inner) continue;
    const auto& [one, other] = naive.edges[graph[edge].index];
    const std::set<std::string> ends{graph[boost::source(edge, graph)].name, graph[boost::target(edge, graph)].name};
    EXPECT_EQ(ends, (std::set{name_of_triangle(one), name_of_triangle(other)})) << where;
  }
}

/// All positions of a family of fans of k triangles, as its name says; true for those that docs/notation.md lists.
std::map<std::vector<int>, bool> positions_by_hand(const std::string& family, int k) {
  std::map<std::vector<int>, bool> positions;
  if (family == "split" || family == "collapse") {
    if (k < 3) return positions;
    for (int a = 1; a < k; ++a) positions[{k, a}] = a <= k / 2;
  } else if (family.starts_with("open-")) {
    for (int i = 0; i <= k; ++i)
      for (int j = i + 1; j <= k; ++j) positions[{k, i, j}] = i + j <= k;
  } else {
    for (int i = 0; i <= k; ++i) positions[{k, i}] = i <= k / 2;
  }
  return positions;
}

TEST(Families, AreThoseOfTheNotation) {
  std::map<std::string, std::map<std::vector<int>, bool>> found;
  std::map<std::string, std::set<std::string>> certificates;
  const auto look_at = [&](const Family& family, const Operation& operation, bool listed) {
    certificates[operation.family].insert(family.name);
    if (operation.family == "flip") return;
    const std::vector<int> numbers(operation.numbers.begin(), operation.numbers.end());
    EXPECT_TRUE(found[operation.family].emplace(numbers, listed).second) << operation.name() << " is there twice";
    EXPECT_FALSE(operation.gives_ports_up || operation.keyed_by_inner);
    const NaiveOperation naive = naive_operation(operation.family, numbers);
    expect_same(operation.before, naive.before, operation.name() + " before");
    expect_same(operation.after, naive.after, operation.name() + " after");
  };
  for (const Family& family : all_families(largest_judged_fan)) {
    for (const Section& section : family.sections)
      for (const Operation& operation : section.operations) look_at(family, operation, true);
    for (const Operation& operation : family.unlisted) look_at(family, operation, false);
  }
  const std::map<std::string, std::set<std::string>> expected{{"split", {"split"}},
                                                              {"collapse", {"collapse"}},
                                                              {"open-split", {"open-split"}},
                                                              {"open-collapse", {"fan-collapse"}},
                                                              {"boundary-split", {"boundary-split"}},
                                                              {"boundary-collapse", {"fan-collapse"}},
                                                              {"flip", {"flip"}}};
  EXPECT_EQ(certificates, expected);
  for (const auto& [family, positions] : found) {
    std::map<std::vector<int>, bool> by_hand;
    for (int k = 1; k <= static_cast<int>(largest_judged_fan); ++k) by_hand.merge(positions_by_hand(family, k));
    EXPECT_EQ(positions, by_hand) << family;
  }
}

// Before, p_0 and p_1 belong to one triangle, p_2 and p_3 to the other; after, p_1 and p_2, p_3 and p_0.
TEST(Families, TheFlip) {
  const Family flip = all_families(3).back();
  ASSERT_EQ(flip.sections.size(), 1U);
  const Operation& operation = flip.sections.front().operations.at(0);
  EXPECT_TRUE(operation.gives_ports_up && operation.keyed_by_inner);
  const auto together = [](const Patch& patch, unsigned one, unsigned other) {
    return patch.owner_of_port(one) == patch.owner_of_port(other);
  };
  for (const auto& [patch, first] : {std::pair{&operation.before, 0U}, {&operation.after, 1U}}) {
    EXPECT_EQ(patch->triangles().size(), 2U);
    EXPECT_EQ(patch->inner_edges(), 1U);
    EXPECT_EQ(patch->ports(), 4U);
    EXPECT_TRUE(together(*patch, first, first + 1) && together(*patch, (first + 2) % 4, (first + 3) % 4));
    EXPECT_FALSE(together(*patch, first, first + 2));
  }
}

const std::string one_family = R"family({
  "restrip_families": 1,
  "families": [{
    "name": "fan", "numbers": ["k", "i"],
    "where": "1 <= k, i < k",
    "position": "k {k} i {i}", "section": "k {k}",
    "before": {"path": ["t[0,k)"]},
    "after": {"ring": ["A", "t[0,k)", "D"], "chord": ["A", "D"]},
    "at_most": [{"where": "i = 2 k + 1", "strips": 0}]
  }]
})family";

TEST(Families, FilesThatAreWrongAreRefusedWithTheLine) {
  const std::vector<FamilyDescription> good = parse_families("f.json", one_family);
  ASSERT_EQ(good.size(), 1U);
  EXPECT_EQ(good[0].positions(3), (std::vector<Numbers>{{1, 0}, {2, 0}, {2, 1}, {3, 0}, {3, 1}, {3, 2}}));
  EXPECT_TRUE(good[0].serves_every_position());
  EXPECT_FALSE(good[0].at_most.at(0).where.hold({3, 6}));
  EXPECT_TRUE(good[0].at_most.at(0).where.hold({3, 7}));
  struct Fault {
    std::string from;
    std::string to;
    std::string said;
  };
  const std::vector<Fault> faults{
      {"{", "\xef\xbb\xbf{", "f.json:1:1: expected no byte order mark before the file; save it as UTF-8 without one"},
      {"\"restrip_families\": 1", "\"restrip_families\": 2", "f.json:2:23: restrip_families: expected version 1"},
      {"\"name\"", "\"nome\"", "f.json:4:5: families[0].nome: unknown member"},
      {"\"name\": \"fan\", ", "", "f.json:3:16: families[0]: expected a member \"name\""},
      {"[\"k\", \"i\"]", "[\"k\", 3]", "families[0].numbers[1]: expected a text, found 3"},
      {"i < k", "j < k", "f.json:5:14: families[0].where: expected a sum of k, i, found \"j\""},
      {"i < k", "i k", "families[0].where: expected a comparison"},
      {"i < k", "i > k", "families[0].where: expected <, <=, >= or ="},
      {"i < k", "i <", "families[0].where: expected a sum of k, i, found \"\""},
      {"t[0,k)\"]}", "t[0 k)\"]}", "f.json:7:25: families[0].before.path[0]: expected a range"},
      {"t[0,k)\"]}", "t[0,k]\"]}", "families[0].before.path[0]: expected a range"},
      {"\"ring\"", "\"circle\"", "f.json:8:15: families[0].after.circle: unknown member"},
      {"\"path\": ", "\"ring\": [\"A\"], \"path\": ", "families[0].before: expected \"ring\" or \"path\", not both"},
      {"[\"A\", \"D\"]", "[\"A\"]", "families[0].after.chord: expected two triangles"},
      {"\"strips\": 0", "\"strips\": 0.5", "f.json:9:52: families[0].at_most[0].strips: expected a number"},
  };
  for (const Fault& fault : faults) {
    std::string text = one_family;
    const std::size_t place = text.find(fault.from);
    ASSERT_NE(place, std::string::npos) << fault.from;
    text.replace(place, fault.from.size(), fault.to);
    try {
      (void)parse_families("f.json", text);
      ADD_FAILURE() << "taken: " << fault.to;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(fault.said), std::string::npos)
          << "expected: " << fault.said << "\nfound: " << error.what();
    }
  }
}

}  // namespace
}  // namespace restrip::verify::test
