// The reader of operation files says of each fault where it is and what was expected. What it takes and what it refuses
// is what docs/operation-file.md says.

#include "model/description.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "model/input.hpp"
#include "verdict.hpp"

namespace restrip::verify::test {
namespace {

/// The message; empty when the text is accepted.
std::string complaint(const std::string& text) {
  try {
    (void)parse_operation("f", text);
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

const std::string good = R"({
  "restrip_operation": 1,
  "name": "two",
  "constraint": "strips",
  "before": {"triangles": 2, "edges": [[0, 1]], "ports": [0, 0, 1, 1]},
  "after": {"triangles": 2, "edges": [[1, 0]], "ports": [1, 0, 0, 1]},
  "give_up": "all",
  "cost": [[{"count": "strips"}]]
}
)";

/// The good file with its first `what` replaced.
std::string with(const std::string& what, const std::string& replacement) {
  std::string text = good;
  const std::size_t place = text.find(what);
  EXPECT_NE(place, std::string::npos) << what;
  return text.replace(place, what.size(), replacement);
}

void expect_complaint(const std::string& what, const std::string& replacement, const std::string& expected) {
  const std::string found = complaint(with(what, replacement));
  EXPECT_EQ(found.substr(0, expected.size()), expected) << found;
  EXPECT_FALSE(expected.empty());
}

void expect_accepted(const std::string& what, const std::string& replacement) {
  EXPECT_EQ(complaint(with(what, replacement)), "");
}

TEST(Description, IsReadAsItIsWritten) {
  const Operation operation = parse_operation("f", good);
  EXPECT_EQ(operation.name(), "two");
  EXPECT_EQ(operation.constraint, Constraint::strips);
  EXPECT_EQ(operation.after.edges, (std::vector<std::array<unsigned, 2>>{{1, 0}}));
  EXPECT_EQ(operation.after.owner_of_port, (std::vector<unsigned>{1, 0, 0, 1}));
  EXPECT_EQ(operation.may_give_up, 15U);
  ASSERT_EQ(operation.cost.size(), 1U);
  EXPECT_EQ(operation.cost[0][0].count, Count::strips);
}

TEST(Description, DefaultsAreThoseOfThePage) {
  const auto text_of_cost = [](const std::string& constraint) {
    std::string text;
    std::string without = with(",\n  \"give_up\": \"all\",\n  \"cost\": [[{\"count\": \"strips\"}]]", "");
    without.replace(without.find("strips"), 6, constraint);
    const Operation operation = parse_operation("f", without);
    EXPECT_EQ(operation.may_give_up, 0U);
    for (const Criterion& criterion : operation.cost) {
      text += '[';
      for (const Term& term : criterion) {
        text += fmt::format(" {}", count_names[static_cast<std::size_t>(term.count)]);
        EXPECT_EQ(term.weight, 1);
      }
      text += " ]";
    }
    return text;
  };
  EXPECT_EQ(text_of_cost("strips"), "[ strips ][ isolated given_up ][ given_up ]");
  EXPECT_EQ(text_of_cost("forest"), "[ strips ][ isolated given_up ][ given_up ]");
  EXPECT_EQ(text_of_cost("matching"), "[ isolated given_up ][ given_up ]");
}

TEST(Description, MembersAreRequiredKnownAndOfTheirTypes) {
  expect_complaint("  \"name\": \"two\",\n", "", "f:1:1: expected a member \"name\"");
  expect_complaint("\"triangles\": 2, ", "", "f:5:13: before: expected a member \"triangles\"");
  expect_complaint("\"name\"", "\"take\": [0], \"name\"",
                   "f:3:11: take: no port can be taken, since a rule does not see");
  expect_complaint("\"name\"", "\"nmae\"", "f:3:3: nmae: unknown member, expected restrip_operation, name,");
  expect_complaint("\"edges\"", "\"edge\"", "f:5:30: before.edge: unknown member, expected triangles, edges, ports");
  expect_complaint("\"name\": \"two\"", "\"name\": \"two\", \"name\": \"three\"",
                   "f:3:18: expected each member once, \"name\" is in line 3 already");
  expect_complaint("operation\": 1", "operation\": 2",
                   "f:2:24: restrip_operation: expected 1, the version of the format, found 2");
  expect_complaint("operation\": 1", "operation\": \"1\"", "f:2:24: restrip_operation: expected 1, the version");
  expect_complaint("operation\": 1", "operation\": 1.0", "f:2:24: restrip_operation: expected 1, the version");
  expect_complaint("\"two\"", "2", "f:3:11: name: expected a name, found 2");
  expect_complaint("\"strips\"", "\"trees\"",
                   "f:4:17: constraint: expected \"strips\", \"matching\" or \"forest\", found \"trees\"");
  expect_complaint("\"strips\"", "null",
                   "f:4:17: constraint: expected \"strips\", \"matching\" or \"forest\", found null");
  expect_complaint("{\"triangles\": 2, \"edges\": [[0, 1]], \"ports\": [0, 0, 1, 1]}", "[2]",
                   "f:5:14: before[0]: expected three vertices, found 2");
  expect_complaint("\"all\"", "\"some\"",
                   "f:7:14: give_up: expected \"none\", \"all\" or a list of ports, found \"some\"");
  expect_complaint("\"all\"", "{}", "f:7:14: give_up: expected \"none\", \"all\" or a list of ports, found an object");
  expect_complaint("\"all\"", "[4]", "f:7:15: give_up[0]: expected ports from 0 to 3, found 4");
  expect_complaint("\"all\"", "[1, 1]", "f:7:18: give_up[1]: expected each port once, 1 is listed above");
  expect_accepted("\"all\"", "[1, 0]");
  expect_accepted("\"all\"", "[]");
  expect_complaint("\"name\"", "\"about\": 3, \"name\"", "f:3:12: about: expected a sentence in quotes, found 3");
}

TEST(Description, Names) {
  const std::string expected = "f:3:11: name: expected at most 60 lower-case letters, digits and single hyphens";
  for (const std::string name : {"", "Two", "2", "-two", "two-", "two--three", "two_three", "two/three", "..", "zwölf"})
    expect_complaint("\"two\"", fmt::format("\"{}\"", name), expected);
  expect_complaint("\"two\"", fmt::format("\"{}\"", std::string(61, 'a')), expected);
  expect_accepted("\"two\"", fmt::format("\"{}\"", std::string(60, 'a')));
  expect_accepted("\"two\"", "\"two-2-b\"");
}

TEST(Description, NamesThatAreTaken) {
  for (const std::string name :
       {"int", "co-await", "split", "flip", "automaton", "pairings", "rule-of", "fn", "vec3", "unix"})
    expect_complaint("\"two\"", fmt::format("\"{}\"", name),
                     fmt::format("f:3:11: name: expected a name that is free, \"{}\" is a", name));
  for (const std::string name : {"int-2", "splits", "rule", "my-class", "co-wait"})
    expect_accepted("\"two\"", fmt::format("\"{}\"", name));
}

TEST(Description, AboutIsOneLineOfAComment) {
  const auto about = [](const std::string& sentence) {
    return fmt::format("\"name\": \"two\", \"about\": \"{}\"", sentence);
  };
  const std::string expected = "f:3:27: about: expected words that can stand in a comment, found ";
  for (const unsigned code :
       {0x0aU, 0x0dU, 0U, 0x1bU, 0x7fU, 0x85U, 0xadU, 0x200bU, 0x2028U, 0x2029U, 0x202eU, 0x2066U, 0xfeffU, 0xfffeU})
    expect_complaint("\"name\": \"two\"", about(fmt::format("One.\\u{:04x}int two;", code)),
                     fmt::format("{}the character U+{:04X}", expected, code));
  expect_complaint("\"name\": \"two\"", about("One. \\\\"), expected + "\"\\\"");
  expect_complaint("\"name\": \"two\"", about("One. */ two"), expected + "\"*/\"");
  expect_complaint("\"name\": \"two\"", about("One. ?\?/"), expected + "\"??\"");
  expect_accepted("\"name\": \"two\"", about("One \\\"two\\\" \\u00e9 \\u2014 \\u20ac? // 'three' \xf0\x9f\x98\x80"));
}

TEST(Description, AByteOrderMarkIsRefused) {
  EXPECT_EQ(complaint("\xef\xbb\xbf" + good),
            "f:1:1: expected no byte order mark before the file; save it as UTF-8 without one");
}

TEST(Description, Limits) {
  expect_complaint("\"triangles\": 2", "\"triangles\": 0",
                   "f:5:27: before.triangles: expected a number from 1 to 16, found 0");
  expect_complaint("\"triangles\": 2", "\"triangles\": 17", "f:5:27: before.triangles: expected a number from 1 to 16");
  expect_accepted("\"triangles\": 2", "\"triangles\": 16");
  expect_complaint("[0, 1]", "[0, 2]", "f:5:44: before.edges[0][1]: expected a triangle from 0 to 1, found 2");
  expect_complaint("[0, 1]", "[-1, 1]", "f:5:41: before.edges[0][0]: expected a triangle from 0 to 1, found -1");
  expect_complaint("[0, 1]", "[0]", "f:5:40: before.edges[0]: expected a pair of triangles");
  expect_complaint("[0, 1]", "[0, 1, 0]", "f:5:40: before.edges[0]: expected a pair of triangles, found a list of 3");
  expect_complaint("[0, 1]", "[1, 1]", "f:5:40: before.edges[0]: expected two different triangles, found 1 twice");
  expect_complaint("[[0, 1]]", "[[0, 1], [1, 0]]",
                   "f:5:48: before.edges[1]: expected each edge once, 1 and 0 are joined above");
  expect_complaint("[0, 0, 1, 1]", "[0, 0, 0, 1]",
                   "f:5:65: before.ports[2]: expected at most three edges and ports of triangle 0, this is the fourth");
  expect_complaint("[1, 0, 0, 1]", "[1, 0, 0]", "f:6:57: after.ports: expected as many ports as before, 4, found 3");
  expect_complaint("[0, 0, 1, 1]", "[]", "f:5:58: before.ports: expected a list of 1 to 8 ports, found none");
  expect_complaint("[0, 0, 1, 1]", "[0, 0, 1, 1, 0, 0, 1, 1, 0]",
                   "f:5:58: before.ports: expected a list of 1 to 8 ports, the triangle of each, found a list of 9");
  // A ring of 16 with 4 ports has 20 colours, one with 5 ports has 21.
  std::vector<std::string> ring;
  for (int i = 0; i < 16; ++i) ring.push_back(fmt::format("[{}, {}]", i, (i + 1) % 16));
  const auto large = [&](const char* ports) {
    return fmt::format("\"triangles\": 16, \"edges\": [{}], \"ports\": {}", fmt::join(ring, ", "), ports);
  };
  expect_accepted("\"triangles\": 2, \"edges\": [[0, 1]], \"ports\": [0, 0, 1, 1]", large("[0, 1, 2, 3]"));
  expect_complaint("\"triangles\": 2, \"edges\": [[0, 1]], \"ports\": [0, 0, 1, 1]", large("[0, 1, 2, 3, 4]"),
                   "f:5:40: before.edges: expected at most 20 edges and ports together, found 16 and 5");
}

TEST(Description, Triangles) {
  const std::string graphs =
      "\"before\": {\"triangles\": 2, \"edges\": [[0, 1]], \"ports\": [0, 0, 1, 1]},\n"
      "  \"after\": {\"triangles\": 2, \"edges\": [[1, 0]], \"ports\": [1, 0, 0, 1]}";
  const auto flip = [&](const std::string& after) {
    return "\"before\": [[\"a\", \"b\", \"c\"], [\"b\", \"a\", \"d\"]],\n  \"after\": " + after;
  };
  const std::string text = with(graphs, flip("[[\"c\", \"a\", \"d\"], [\"d\", \"b\", \"c\"]]"));
  const Operation operation = parse_operation("f", text);
  EXPECT_TRUE(operation.on_a_mesh());
  EXPECT_EQ(operation.before.owner_of_port, (std::vector<unsigned>{0, 0, 1, 1}));
  EXPECT_EQ(operation.after.edges, (std::vector<std::array<unsigned, 2>>{{0, 1}}));
  EXPECT_EQ(operation.after.owner_of_port, (std::vector<unsigned>{1, 0, 0, 1}));
  EXPECT_FALSE(parse_operation("f", good).on_a_mesh());
  const auto expect = [&](const std::string& after, const std::string& expected) {
    expect_complaint(graphs, flip(after), expected);
  };
  expect("[]", "f:6:12: after: expected a list of triangles, found none");
  expect("3", "f:6:12: after: expected a list of 1 to 16 triangles, found 3");
  expect("[[\"c\", \"a\"]]", "f:6:13: after[0]: expected three vertices");
  expect("[[\"c\", \"a\", 1]]", "f:6:24: after[0][2]: expected the name of a vertex, found 1");
  expect("[[\"c\", \"a\", \"d\"], [\"d\", \"e\", \"c\"]]",
         "f:5:14: before[0]: expected the same rim on both sides, the edge b c is on it before");
  expect("[[\"c\", \"a\", \"d\"], [\"d\", \"b\", \"c\"]], \"boundary\": [[\"a\", \"e\"]]",
         "f:6:61: boundary[0]: expected vertices that the rim has on both sides, \"e\" is not there");
  expect("[[\"c\", \"a\", \"d\"], [\"d\", \"b\", \"c\"]], \"boundary\": [[\"a\", \"a\"]]",
         "f:6:61: boundary[0]: expected two different vertices");
}

TEST(Description, Costs) {
  const std::string cost = "[[{\"count\": \"strips\"}]]";
  const auto expect = [&](const std::string& replacement, const std::string& expected) {
    expect_complaint(cost, replacement, expected);
  };
  expect("3", "f:8:11: cost: expected a list of 1 to 8 criteria, found 3");
  expect("[]", "f:8:11: cost: expected a list of 1 to 8 criteria, found none");
  expect("[[]]", "f:8:12: cost[0]: expected a list of 1 to 64 terms, found none");
  expect("[{\"count\": \"strips\"}]", "f:8:12: cost[0]: expected a list of 1 to 64 terms, found an object");
  expect("[[\"strips\"]]", "f:8:13: cost[0][0]: expected an object, found \"strips\"");
  expect("[[{}]]", "f:8:13: cost[0][0]: expected a member \"count\"");
  expect("[[{\"count\": \"stripes\"}]]", "f:8:23: cost[0][0].count: expected \"strips\", \"isolated\", \"given_up\"");
  expect("[[{\"count\": \"strips\", \"wieght\": 2}]]",
         "f:8:33: cost[0][0].wieght: unknown member, expected count, weight, edges, triangles, ports");
  for (const char* weight : {"1000001", "-1000001", "1.5", "1e2", "\"1\"", "true"})
    expect(fmt::format("[[{{\"count\": \"strips\", \"weight\": {}}}]]", weight),
           "f:8:43: cost[0][0].weight: expected an integer from -1000000 to 1000000, found ");
  expect("[[{\"count\": \"strips\", \"edges\": [0]}]]",
         "f:8:42: cost[0][0].edges: unknown member, \"strips\" is not counted among edges");
  expect("[[{\"count\": \"solid\", \"triangles\": [0]}]]",
         "f:8:45: cost[0][0].triangles: unknown member, \"solid\" is not counted among triangles");
  expect("[[{\"count\": \"solid\", \"edges\": [1]}]]",
         "f:8:42: cost[0][0].edges[0]: expected edges from 0 to 0, found 1");
  expect("[[{\"count\": \"kept\", \"ports\": [4]}]]",
         "f:8:41: cost[0][0].ports[0]: expected ports from 0 to 3, found 4");
  expect("[[{\"count\": \"ends\", \"triangles\": [0, 0]}]]",
         "f:8:48: cost[0][0].triangles[1]: expected each triangle once, 0 is listed above");
  std::string nine = "[";
  for (int i = 0; i < 9; ++i) nine += fmt::format("{}[{{\"count\": \"strips\"}}]", i == 0 ? "" : ", ");
  expect(nine + "]", "f:8:11: cost: expected a list of 1 to 8 criteria, found a list of 9");
  for (const std::string_view name : count_names)
    expect_accepted(cost, fmt::format("[[{{\"count\": \"{}\", \"weight\": -1000000}}]]", name));
  expect_accepted(cost,
                  "[[{\"count\": \"ends_at_port\", \"triangles\": [1]}, {\"count\": \"solid\", \"edges\": [0]}]]");
}

TEST(Description, WhatIsNotJson) {
  const auto expect = [&](const std::string& text, const std::string& expected) {
    const std::string found = complaint(text);
    EXPECT_EQ(found.substr(0, expected.size()), expected) << found;
  };
  expect("", "f:1:1: not JSON: syntax error while parsing value - unexpected end of input");
  expect("{\n  \"name\" 3}", "f:2:10: not JSON: syntax error while parsing object separator");
  expect("{\"name\": 3,}", "f:1:12: not JSON: syntax error while parsing object key - unexpected '}'");
  expect("{name: 3}", "f:1:3: not JSON: ");
  expect("{\"a\": [1, 2}", "f:1:12: not JSON: syntax error while parsing array - unexpected '}'");
  expect("{\"a\": 1", "f:1:8: not JSON: syntax error while parsing object - unexpected end of input");
  expect("{\"a\": 01}", "f:1:8: not JSON: ");
  expect("{\"a\": 1.}", "f:1:9: not JSON: ");
  expect("{\"a\": +1}", "f:1:7: not JSON: ");
  expect("{\"a\": \"b\n\"}", "f:1:9: not JSON: ");
  expect("{\"a\": \"\\x\"}", "f:1:9: not JSON: ");
  expect("{\"a\": \"\\u12g4\"}", "f:1:12: not JSON: ");
  expect("{\"a\": \"\\ud800\"}", "f:1:14: not JSON: ");
  expect("{\"a\": \"\xff\"}", "f:1:8: not JSON: ");
  expect("{\"a\": \"\xc0\xaf\"}", "f:1:8: not JSON: ");
  expect("{\"a\": tru}", "f:1:10: not JSON: ");
  expect(good + "{}", "f:10:1: not JSON: ");
  expect(std::string(100, '['), "f:1:10: expected fewer lists and objects inside one another");
  EXPECT_EQ(parse_descriptions("f", with("\"name\": \"two\"", R"("name": "tw\u006f", "about": "\u00e9\ud83d\ude00\"")"))
                .front()
                .about,
            "\xc3\xa9\xf0\x9f\x98\x80\"");
  for (std::size_t length = 0; length + 2 < good.size(); ++length)
    EXPECT_NE(complaint(good.substr(0, length)), "") << length;
}

TEST(Description, AMissingFileIsNamed) {
  const Verdict verdict = verdict_on("nowhere.json", "", {});
  EXPECT_EQ(verdict.exit_code, 2);
  EXPECT_TRUE(verdict.says("nowhere.json: cannot be opened")) << verdict.text;
}

}  // namespace
}  // namespace restrip::verify::test
