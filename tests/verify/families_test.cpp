// The families of tables/families.json match docs/reference/notation.md: every position of fans up to ten triangles
// exists, listed or not as that page says, and its patches equal the handwritten ones of the tests. Files that do not
// describe a family are refused with their line: Description.OneAlterationIsNamed.

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <string>
#include <vector>

#include "../support/refusal_of.hpp"
#include "corpus.hpp"
#include "model/description.hpp"
#include "model/input.hpp"
#include "naive_tables.hpp"

namespace restrip::verify::test {
namespace {

void expect_same(const Side& found, const Side& by_hand, const std::string& where) {
  EXPECT_EQ(found.triangles, by_hand.triangles) << where;
  if (!by_hand.names.empty()) {
    EXPECT_EQ(found.names, by_hand.names) << where;
  }
  EXPECT_EQ(found.edges, by_hand.edges) << where;
  EXPECT_EQ(found.owner_of_port, by_hand.owner_of_port) << where;
}

void expect_same(const Operation& found) {
  const Operation by_hand = operation_by_hand(found.family, found.numbers);
  EXPECT_EQ(found.name(), by_hand.name());
  expect_same(found.before, by_hand.before, found.name() + " before");
  expect_same(found.after, by_hand.after, found.name() + " after");
  EXPECT_EQ(found.constraint, Constraint::strips);
  EXPECT_EQ(found.may_give_up, by_hand.may_give_up) << found.name();
  EXPECT_EQ(found.cost, by_hand.cost) << found.name();
}

/// All positions of a family of fans of k triangles, given by its name; true for positions that
/// docs/reference/notation.md lists.
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

TEST(Families, AgreeWithTheNotation) {
  std::map<std::string, std::map<std::vector<int>, bool>> found;
  std::map<std::string, std::set<std::string>> certificates;
  const auto look_at = [&](const Family& family, const Operation& operation, bool listed) {
    certificates[operation.family].insert(family.name);
    expect_same(operation);
    if (operation.family == "flip") return;
    const std::vector<int> numbers(operation.numbers.begin(), operation.numbers.end());
    EXPECT_TRUE(found[operation.family].emplace(numbers, listed).second) << operation.name() << " is there twice";
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

TEST(Families, AreReadAtTheirPositions) {
  const std::vector<Description> good = parse_descriptions("f.json", text_to_alter("fan.json"));
  ASSERT_EQ(good.size(), 1U);
  EXPECT_EQ(good[0].positions(3), (std::vector<Numbers>{{2, 0}, {2, 1}, {3, 0}, {3, 1}, {3, 2}}));
  EXPECT_FALSE(good[0].serves_every_position());
  EXPECT_EQ(good[0].at({3, 1}).most_strips, std::nullopt);
  EXPECT_EQ(good[0].at({3, 2}).most_strips, 0);
}

// A section has no rules to offer if it omits a number on which the patch after depends.
TEST(Families, SectionsServeOnePatch) {
  std::string text(families_text);
  text.insert(text.find("\"before\""), R"("section": "k {k}", )");
  EXPECT_EQ(refusal_of<InputError>([&] { (void)families_of(parse_descriptions("f.json", text, Author::restrip), 4); }),
            "f.json: section k 4 cannot serve both split k 4 a 1 and split k 4 a 2: they differ after the operation");
}

}  // namespace
}  // namespace restrip::verify::test
