// The header of an operation's table is the text that docs/operation-file.md says, but for its numbers: whatever else
// is put into it, at whatever place, is found.

#include "judge/operation_header.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "model/family.hpp"
#include "model/input.hpp"

namespace restrip::verify::test {
namespace {

struct Header {
  Description description;
  std::string text;

  /// One that is shipped.
  explicit Header(const std::string& name) : Header(read_file(shipped("/operations/" + name + ".json")), {}) {
    std::string header = name;
    std::replace(header.begin(), header.end(), '-', '_');
    text = read_file(shipped("/include/restrip/tables/operations/" + header + ".hpp"));
  }
  Header(const std::string& file, std::string header)
      : description(parse_descriptions("f", file).front()), text(std::move(header)) {}

  std::string complaint(const std::string& altered) const {
    return check_operation_header("h", altered, description, largest_fan).wrong.first;
  }
  /// When the first `what` is something else.
  std::string with(const std::string& what, const std::string& other) const {
    std::string altered = text;
    const std::size_t at = altered.find(what);
    EXPECT_NE(at, std::string::npos) << what;
    return complaint(altered.replace(at, what.size(), other));
  }

 private:
  static std::string shipped(const std::string& path) { return RESTRIP_TABLES_DIR + path; }
};

/// A patch that is given as a graph has no triangles in its header.
Header graph() {
  return {R"({"restrip_operation": 1, "name": "new-corner", "constraint": "strips",
    "before": {"triangles": 1, "edges": [], "ports": [0, 0, 0]},
    "after": {"triangles": 3, "edges": [[0, 1], [1, 2], [2, 0]], "ports": [0, 1, 2]}})",
          R"(// new-corner
// Written by `restrip-generate rules` from the operation file of new-corner. Do not edit.
// Explained in restrip/tables/operation_format.hpp.
#pragma once

#include "restrip/tables/operation_format.hpp"

namespace restrip::tables {

inline constexpr OperationTable<std::uint8_t, 8> new_corner{
    {1, 0},
    {3, 3},
    3,
    false,
    {
    24, 25, 26, 35,
    28, 21, 14, 255,
    }};

}  // namespace restrip::tables
)"};
}

/// A family has all its positions, and says where their entries begin.
Header family() {
  return {
      R"family({"restrip_operation": 1, "name": "fan-turns", "numbers": ["k", "i"], "where": "1 <= k, k <= 2, i < 1",
    "listed": "i < 1", "position": "\"k\" {k} i {i}",
    "before": {"path": ["t[0,k)"]}, "after": {"path": ["t[0,k)"]}})family",
      R"(// fan-turns
// Written by `restrip-generate rules` from the operation file of fan-turns. Do not edit.
// Explained in restrip/tables/operation_format.hpp.
#pragma once

#include "restrip/tables/operation_format.hpp"

namespace restrip::tables {

inline constexpr OperationFamily<std::uint8_t, 10, 2> fan_turns{
    false,
    "\"k\" {0} i {1}",
    {{
    {{1, 0, 0}, {1, 0}, {1, 0}, 1, 0},
    {{2, 0, 0}, {2, 1}, {2, 1}, 2, 2},
    }},
    {
    0, 1, 4, 5, 6, 7, 4, 5,
    6, 7,
    }};

}  // namespace restrip::tables
)"};
}

/// And one of triangles where those of each position begin.
Header family_of_triangles() {
  return {R"family({"restrip_operation": 1, "name": "fan-stays", "numbers": ["k"], "where": "1 <= k, k <= 2",
    "before": [["v", "u[i]", "u[i+1]", "i[0,k)"]], "after": [["v", "u[i]", "u[i+1]", "i[0,k)"]]})family",
          R"(// fan-stays
// Written by `restrip-generate rules` from the operation file of fan-stays. Do not edit.
// Explained in restrip/tables/operation_format.hpp.
#pragma once

#include "restrip/tables/operation_format.hpp"

namespace restrip::tables {

inline constexpr SurfaceFamily<std::uint8_t, 40, 2, 3, 3> fan_stays{
    {false,
    "k {0}",
    {{
    {{1, 0, 0}, {1, 0}, {1, 0}, 3, 0},
    {{2, 0, 0}, {2, 1}, {2, 1}, 4, 8},
    }},
    {
    0, 1, 2, 3, 4, 5, 6, 255, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11,
    12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29, 30, 31,
    }},
    {{
    {3, 0, 0},
    {4, 1, 1},
    }},
    {{
    {0, 0, {0, 1, 2}, {64, 65, 66}}, {0, 0, {0, 1, 2}, {64, 65, 0}}, {0, 2, {0, 2, 3}, {0, 66, 67}},
    }},
    {{
    {0, 0, {0, 1, 2}, {64, 65, 66}}, {0, 0, {0, 1, 2}, {64, 65, 0}}, {0, 2, {0, 2, 3}, {0, 66, 67}},
    }},
};

}  // namespace restrip::tables
)"};
}

TEST(OperationHeader, ShippedOnesAreTables) {
  for (const std::string name : {"bisect", "bisect-boundary", "merge", "merge-matching", "split-face"}) {
    const Header shipped(name);
    EXPECT_EQ(shipped.complaint(shipped.text), "") << name;
    EXPECT_GT(check_operation_header("h", shipped.text, shipped.description, largest_fan).lines, 18U);
  }
  EXPECT_EQ(graph().complaint(graph().text), "");
  EXPECT_EQ(family().complaint(family().text), "");
  EXPECT_EQ(family_of_triangles().complaint(family_of_triangles().text), "");
}

TEST(OperationHeader, OfAFamilyHasItsPositions) {
  EXPECT_EQ(family().with("{{2, 0, 0}", "{{2, 1, 0}").substr(0, 46), "h:15: expected \"    {{2, 0, 0}, {2, 1}, {2, 1}");
  for (const auto& [what, other] : std::vector<std::pair<std::string, std::string>>{{"2, 2},\n", "2, 1},\n"},
                                                                                    {"{1, 0}, 1", "{1, 0}, 2"},
                                                                                    {"10, 2>", "10, 3>"},
                                                                                    {"k\\\"", "k\""},
                                                                                    {"{0}", "{1}"},
                                                                                    {"false", "true"}})
    EXPECT_NE(family().with(what, other), "") << what;
}

// Of the second position the triangles are two, the vertices four, the ports four.
TEST(OperationHeader, OfAFamilyHasTheTrianglesOfItsPositions) {
  const Header header = family_of_triangles();
  const std::string second = "{0, 2, {0, 2, 3}, {0, 66, 67}},";
  for (const std::string other :
       {"{1, 0, {3, 3, 3}, {255, 255, 255}},", "{0, 2, {0, 3, 2}, {0, 66, 67}},", "{2, 2, {0, 2, 3}, {0, 66, 67}},",
        "{0, 2, {0, 2, 4}, {0, 66, 67}},", "{0, 2, {0, 2, 3}, {1, 66, 67}},", "{0, 2, {0, 2, 3}, {0, 66, 68}},", ""})
    EXPECT_NE(header.with(second, other), "") << other;
  const std::string first = "{0, 0, {0, 1, 2}, {64, 65, 66}},";
  for (const std::string other : {"{1, 0, {0, 1, 2}, {64, 65, 66}},", "{0, 0, {0, 1, 3}, {64, 65, 66}},",
                                  "{0, 0, {0, 1, 2}, {64, 65, 0}},", "{0, 0, {0, 1, 2}, {64, 65, 67}},"})
    EXPECT_NE(header.with(first, other), "") << other;
  for (const std::string other : {"{3, 1, 0}", "{4, 0, 0}"}) EXPECT_NE(header.with("{3, 0, 0}", other), "") << other;
  EXPECT_NE(header.with("{4, 1, 1}", "{4, 1, 2}"), "");
  EXPECT_NE(header.with("3, 3>", "3, 2>"), "");
}

TEST(OperationHeader, OfAnotherOperationIsNot) {
  EXPECT_EQ(Header("bisect").complaint(Header("merge").text).substr(0, 30), "h:1: expected \"// A new vertex");
}

TEST(OperationHeader, AnyByteThatIsNoDigitOfATableIsMissed) {
  for (const Header& header : {Header("bisect"), graph(), family(), family_of_triangles()})
    for (std::size_t at = 0; at < header.text.size(); ++at) {
      for (const char c : std::string_view("x\"\n\r\\(;#/ \0", 11)) {
        std::string altered = header.text;
        if (altered[at] != c) {
          altered[at] = c;
          EXPECT_NE(header.complaint(altered), "") << at << " becomes " << c;
        }
        altered = header.text;
        altered.insert(at, 1, c);
        EXPECT_NE(header.complaint(altered), "") << c << " at " << at;
      }
      if (const char c = header.text[at]; c < '0' || c > '9') {
        std::string altered = header.text;
        altered.erase(at, 1);
        EXPECT_NE(header.complaint(altered), "") << "without " << at;
      }
      EXPECT_NE(header.complaint(header.text.substr(0, at)), "") << "cut at " << at;
    }
}

TEST(OperationHeader, NumbersAreThoseOfTheTable) {
  const Header bisect("bisect");
  EXPECT_EQ(bisect.with(" 112,", " 113,"), "");
  const std::string expected =
      "h:16: expected rules of the operation, or 65535, each with a comma, 32 in all, found \"    ";
  for (const std::string other :
       {" 0112,", " 256,", " 65534,", " 65536,", " -1,", " 0x70,", " 112u,", " 1 + 1,", " (112),"})
    EXPECT_EQ(bisect.with(" 112,", other).substr(0, expected.size()), expected) << other;
  EXPECT_NE(bisect.with(" 112,", " 112, 1,"), "");
  EXPECT_NE(bisect.with(" 112,", ""), "");
}

TEST(OperationHeader, TrianglesAreThoseOfTheDescription) {
  const Header bisect("bisect");
  const std::string expected =
      "h:21: expected the triangles {0, 0, {0, 1, 2}, {0, 64, 65}}, {0, 0, {1, 0, 3}, {0, 66, 67}}, "
      "each with a comma, 2 in all, found \"    ";
  const std::string first = " {0, 0, {0, 1, 2}, {0, 64, 65}},";
  for (const std::string other :
       {" {1, 2, {4, 4, 4}, {0, 67, 255}},", " {0, 1, {0, 1, 2}, {0, 64, 65}},", " {0, 0, {1, 0, 2}, {0, 64, 65}},",
        " {0, 0, {0, 1, 2}, {0, 65, 64}},", " {0, 0, {0, 1, 2}, {64, 0, 65}},", " {0, 0, {0, 1, 2}, {0, 64, 255}},",
        " {0, 0, {0, 1, 02}, {0, 64, 65}},", " {0, 0, {0, 1, 2}, {0, 64}},"})
    EXPECT_EQ(bisect.with(first, other).substr(0, expected.size()), expected) << other;
  // A triangle after the operation, met over another side.
  EXPECT_NE(bisect.with("{1, 2, {4, 0, 3}, {1, 66, 2}}", "{2, 1, {3, 4, 0}, {2, 1, 66}}"), "");
  EXPECT_NE(bisect.with(first, first + first), "");
  EXPECT_NE(bisect.with(first, ""), "");
  EXPECT_NE(bisect.with("\n    5,\n", "\n    6,\n"), "");
}

// Every shipped header says what its description has, and no entry may be another number.
TEST(OperationHeader, EntriesAreJudged) {
  const Header merge("merge");
  const Family family = families_of({merge.description}, largest_fan).front();
  ExpectedDump expected;
  expected.tables.push_back({&family.sections.front().operations.front(), Against::own_patch, nullptr});
  HeaderCheck header = check_operation_header("h", merge.text, merge.description, largest_fan);
  ASSERT_EQ(header.entries.size(), 256U);
  const auto wrong = [&] { return compare_header(header, expected).of(Against::own_patch).wrong.count; };
  EXPECT_EQ(wrong(), 0U);
  std::size_t refused = 0;
  for (std::uint32_t& entry : header.entries) {
    const std::uint32_t right = std::exchange(entry, entry == 255 ? 0 : 255);
    refused += wrong();
    entry = right;
  }
  EXPECT_EQ(refused, header.entries.size());
}

}  // namespace
}  // namespace restrip::verify::test
