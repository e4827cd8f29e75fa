// The reader of operation files reports the place of each fault and what was expected. It accepts and refuses files as
// docs/reference/operation-file.md says.

#include "model/description.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "../support/refusal_of.hpp"
#include "corpus.hpp"
#include "model/input.hpp"
#include "verdict.hpp"

namespace restrip::verify::test {
namespace {

/// The message; empty when the text is accepted.
std::string complaint(const std::string& text) {
  return refusal_of([&] { (void)parse_descriptions("f", text); });
}

const std::string good = text_to_alter("two.json");

/// The good file with its first `what` replaced.
std::string with(const std::string& what, const std::string& by) {
  return Alteration{"two.json", what, by, {}}.in(good);
}

void expect_said(const std::string& text, const std::string& expected) {
  const std::string found = complaint(text);
  EXPECT_EQ(found.empty(), expected.empty()) << text << found;
  EXPECT_NE(found.find(expected), std::string::npos) << "expected: " << expected << "\nfound: " << found;
}

void expect_name(const std::string& name, const std::string& expected) {
  expect_said(with("\"two\"", fmt::format("\"{}\"", name)), expected);
}

TEST(Description, IsReadAsItIsWritten) {
  const Operation operation = parse_operation("f", good);
  EXPECT_EQ(operation.name(), "two");
  EXPECT_EQ(operation.constraint, Constraint::strips);
  EXPECT_EQ(operation.before.owner_of_port, (std::vector<unsigned>{0, 0, 1, 1}));
  EXPECT_EQ(operation.after.edges, (std::vector<std::array<unsigned, 2>>{{0, 1}}));
  EXPECT_EQ(operation.before.names, (std::vector<std::string>{"abc", "bad"}));
  EXPECT_EQ(operation.after.port_names, (std::vector<std::string>{"b c", "c a", "a d", "d b"}));
  EXPECT_EQ(operation.after.owner_of_port, (std::vector<unsigned>{1, 0, 0, 1}));
  EXPECT_EQ(operation.may_give_up, 15U);
  ASSERT_EQ(operation.cost.size(), 1U);
  EXPECT_EQ(operation.cost[0][0].count, Count::strips);
}

TEST(Description, DefaultsAgreeWithThePage) {
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
  EXPECT_EQ(text_of_cost("matching"), "[ isolated given_up ][ given_up ]");
}

TEST(Description, OneAlterationIsNamed) {
  for (const char* file : {"descriptions.txt", "surfaces.txt"})
    for (const Alteration& alteration : alterations(file))
      expect_said(alteration.in(text_to_alter(alteration.of)), alteration.says);
}

TEST(Description, Names) {
  const std::string expected = "f:3:11: name: expected at most 60 lower-case letters, digits and single hyphens";
  for (const std::string name : {"", "Two", "2", "-two", "two-", "two--three", "two_three", "two/three", "..", "zwölf"})
    expect_name(name, expected);
  expect_name(std::string(61, 'a'), expected);
  expect_name(std::string(60, 'a'), "");
  // Generated names have a suffix, so words of languages, macros and names of the library are free.
  for (const std::string name : {"two-2-b", "int", "co-await", "split", "automaton", "rule-of", "fn", "union", "unix"})
    expect_name(name, "");
}

TEST(Description, AboutIsOneLineOfAComment) {
  for (const unsigned code :
       {0x0aU, 0x0dU, 0U, 0x1bU, 0x7fU, 0x85U, 0xadU, 0x200bU, 0x2028U, 0x2029U, 0x202eU, 0x2066U, 0xfeffU, 0xfffeU})
    expect_said(with("\"two\"", fmt::format("\"two\", \"about\": \"One.\\u{:04x}int two;\"", code)),
                fmt::format("f:3:27: about: expected words that can stand in a comment, found U+{:04X}", code));
}

TEST(Description, AByteOrderMarkIsRefused) {
  for (const char* name : {"two.json", "fan.json"})
    expect_said("\xef\xbb\xbf" + text_to_alter(name),
                "f:1:1: expected no byte order mark before the file; save it as UTF-8 without one");
}

TEST(Description, EveryCountCanBeWeighed) {
  for (const std::string_view name : count_names)
    expect_said(
        with("[[{\"count\": \"strips\"}]]", fmt::format("[[{{\"count\": \"{}\", \"weight\": -1000000}}]]", name)), "");
}

// tests/common/json_test.cpp has texts that are not JSON.
TEST(Description, WhatIsNotJson) {
  expect_said("{\n  \"name\" 3}", "f:2:10: not JSON: syntax error while parsing object separator");
  expect_said(good + "{}", "f:10:1: not JSON: ");
  expect_said(std::string(100, '['), "f:1:9: expected lists and objects at most 8 deep inside one another");
  for (std::size_t length = 0; length + 2 < good.size(); ++length)
    EXPECT_NE(complaint(good.substr(0, length)), "") << length;
}

/// Small files that once took gigabytes or minutes, and limits of positions.
TEST(Description, LimitsOfThePage) {
  const std::string fan = text_to_alter("fan.json");
  const auto many = [](const std::string& text, unsigned times) {
    std::string all;
    for (unsigned i = 0; i < times; ++i) all += text;
    return all;
  };
  const auto with_member = [&](const std::string& member) { return with("\"name\"", member + ", \"name\""); };
  expect_said(with_member(fmt::format("\"boundary\": [{}0]", many("0, ", 400'000))),
              "expected a list of at most 22 stretches");
  expect_said(with_member("\"" + std::string(100'000, 'm') + "\": 1"),
              "f:3:3: expected names of members of at most 60 bytes");
  expect_said(with_member("\"m\": {" + many("\"m\": 1, ", 2) + "\"n\": 1}"), "expected each member once");
  std::string members;
  for (unsigned i = 0; i < 65; ++i) members += fmt::format("{}\"m{}\": 1", i == 0 ? "" : ", ", i);
  expect_said(with_member("\"m\": {" + members + "}"), "expected at most 64 members of an object");
  const auto altered = [&](const std::string& what, const std::string& by) {
    return Alteration{"fan.json", what, by, {}}.in(fan);
  };
  expect_said(altered("\"where\": \"", "\"where\": \"k < 99 k" + many(" + 9999 k", 100'000) + ", "),
              "expected a sum of at most 16 terms");
  expect_said(altered("\"where\": \"", "\"where\": \"" + many("k >= 1, ", 100'000)), "expected at most 16 comparisons");
  EXPECT_LT(complaint(altered("\"where\": \"", "\"where\": \"" + std::string(900'000, 'q'))).size(), 600U);
  expect_name("split-face",
              "\"split-face\" is an operation of restrip, tables/operations/split-face.json, and this is another one");
  for (const char* number : {"k", "I", ""})
    expect_said(altered("[\"k\", \"i\"]", fmt::format("[\"k\", \"i\", \"{}\"]", number)), "numbers[2]: expected ");
  for (const char* more : {"{0}", "{k}", "{", "{j}"})
    expect_said(altered("k {k} i {i}", fmt::format("k {{k}} i {{i}} {}", more)),
                "position: expected braces only around numbers, around each once at most");
  const Description family = parse_descriptions("f", fan).front();
  EXPECT_NO_THROW((void)family.at({10, 1}));
  EXPECT_THROW((void)family.at({11, 1}), files::FileError);
}

TEST(Description, AMissingFileIsNamed) {
  const Verdict verdict = verdict_on("nowhere.json", "", {});
  EXPECT_EQ(verdict.exit_code, 2);
  EXPECT_TRUE(verdict.says("nowhere.json: no such file")) << verdict.text;
}

}  // namespace
}  // namespace restrip::verify::test
