// Claims: JSON is read within the caller's limits, values and their places are those of the file, escapes included, and
// whatever is refused is refused with the file, the place and the path.
#include "common/json.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "support/refusal_of.hpp"

namespace restrip {
namespace {

std::string complaint(std::string_view text, const JsonLimits& limits) {
  return refusal_of([&] { (void)parse_json("f", text, limits); });
}

constexpr JsonLimits lenient{.strict = false};

TEST(Json, ValuesAreThoseOfTheFile) {
  const JsonValue all = parse_json("f", "{\"a\": [1, -2, 3.0, 4.5, 1e2, \"t\", true, [], {}],\n \"b\": null}", lenient);
  const JsonValue list = all["a"];
  ASSERT_EQ(list.size(), 9U);
  EXPECT_EQ(list.at(0).whole(), 1U);
  EXPECT_EQ(list.at(1).number(-5, 5, "a number"), -2);
  EXPECT_EQ(list.at(2).whole(), 3U);
  EXPECT_EQ(list.at(3).real(), 4.5);
  EXPECT_EQ(list.at(4).whole(), 100U);
  EXPECT_EQ(list.at(5).text(), "t");
  EXPECT_TRUE(list.at(6).truth());
  EXPECT_EQ(list.at(7).size(), 0U);
  EXPECT_TRUE(list.at(8).members().empty());
  EXPECT_EQ(all["b"].where(), "f:2:7: b: ");
  EXPECT_EQ(list.at(8).where(), "f:1:45: a[8]: ");
}

TEST(Json, TextsAndNamesMayHaveEscapes) {
  const std::string text = R"({"a\u0062": "x\n\u00e9\ud83d\ude00\"", "plain": "y", "é": ["\\", "z"]})";
  for (const bool strict : {false, true}) {
    const JsonValue all = parse_json("f", text, {.strict = strict});
    EXPECT_EQ(all["ab"].text(), "x\n\u00e9\U0001F600\"");
    EXPECT_EQ(all["plain"].text(), "y");
    EXPECT_EQ(all["é"].at(0).text(), "\\");
    EXPECT_EQ(all["é"].at(1).where(), "f:1:67: \\xc3\\xa9[1]: ");
    EXPECT_FALSE(all["a"].there());
  }
}

TEST(Json, MembersAreFoundInAnyOrder) {
  std::string text = "{";
  std::vector<std::string> names;
  names.reserve(60);
  for (int i = 0; i < 60; ++i) names.push_back(fmt::format("{}", i * 37 % 60));
  for (const std::string& name : names) text += fmt::format("\"{0}\":{0},", name);
  text.back() = '}';
  const JsonValue strict = parse_json("f", text);
  const JsonValue sorted = parse_json("f", text, lenient);
  for (const std::string& name : names) {
    EXPECT_EQ(fmt::format("{}", strict[name].whole()), name);
    EXPECT_EQ(fmt::format("{}", sorted[name].whole()), name);
  }
  EXPECT_EQ(strict.members(), names);
  std::sort(names.begin(), names.end());
  EXPECT_EQ(sorted.members(), names);
  EXPECT_FALSE(sorted["60"].there() || strict["60"].there());
}

TEST(Json, LimitsAreTheCallers) {
  EXPECT_EQ(complaint("[[[1]]]", {.deepest = 3}), "");
  EXPECT_EQ(complaint("[\n[[1]]]", {.deepest = 2}),
            "f:2:2: expected lists and objects at most 2 deep inside one another");
  EXPECT_EQ(complaint("[1,{\"a\":2}]", {.most_values = 4}), "");
  EXPECT_EQ(complaint("[1,{\"a\":2}]", {.most_values = 3}),
            "f:1:1: more than 3 values, the limit; keep numbers in a buffer");
  EXPECT_EQ(complaint("{\"a\":1,\"b\":2}", {.most_members = 1}), "f:1:8: expected at most 1 members of an object");
  EXPECT_EQ(complaint("{\"abc\":1}", {.longest_member = 3}), "");
  EXPECT_NE(complaint("{\"abc\":1}", {.longest_member = 2}), "");
  // Deep nesting neither here nor in the parser takes stack.
  const std::string deep = std::string(300'000, '[') + std::string(300'000, ']');
  EXPECT_EQ(complaint(deep, lenient), "");
  EXPECT_NE(complaint(deep, operation_file_limits), "");
}

TEST(Json, StrictFilesHaveNoByteOrderMarkAndNoDuplicates) {
  const std::string twice = "{\"a\":1,\n\"b\":2,\n\"a\":3}";
  EXPECT_EQ(complaint(twice, {}), "f:3:1: expected each member once, \"a\" is in line 1 already");
  EXPECT_EQ(parse_json("f", twice, lenient)["a"].whole(), 3U);
  const std::string marked = "\xef\xbb\xbf[7]";
  EXPECT_NE(complaint(marked, {}).find("f:1:1: expected no byte order mark"), std::string::npos);
  const JsonValue value = parse_json("f", marked, lenient).at(0);
  EXPECT_EQ(value.whole(), 7U);
  EXPECT_EQ(value.where(), "f:1:5: [0]: ");
}

TEST(Json, ZeroBytesDoNotEndIt) {
  using namespace std::string_literals;
  const JsonLimits inside{.strict = false, .has_lines = false};
  for (const auto& [text, place] : {std::pair{"[7]\n\0"s, "f:2:1"},
                                    {"[7]\0{"s, "f:1:4"},
                                    {"7\0 8"s, "f:1:2"},
                                    {"\0[7]"s, "f:1:1"},
                                    {"[\"\0\"]"s, "f:1:3"},
                                    {"[7\0]\0"s, "f:1:3"}}) {
    EXPECT_EQ(complaint(text, {}), place + ": not JSON: a zero byte"s);
    EXPECT_EQ(complaint(text, lenient), place + ": not JSON: a zero byte"s);
    EXPECT_EQ(complaint(text, inside).empty(), text.ends_with("\n\0"s));
  }
  EXPECT_EQ(parse_json("f.glb", "7\0\0\0"s, inside).whole(), 7U);
}

TEST(Json, WhatIsRefusedIsNamed) {
  const JsonValue all = parse_json("f", "{\"a\":\n{\"b\": [1, \"x\"]}}", lenient);
  const auto said = [&](const auto& read) { return refusal_of([&] { (void)read(); }); };
  EXPECT_EQ(said([&] { return all["a"]["b"].at(1).whole(); }), "f:2:11: a.b[1]: expected a number, found \"x\"");
  EXPECT_EQ(said([&] { return all["a"]["b"].at(2); }), "f:2:7: a.b: has no element 2, only 2");
  EXPECT_EQ(said([&] { return all["a"]["c"]["d"].text(); }), "f:2:1: a: expected a member \"c.d\"");
  EXPECT_EQ(said([&] { return all["x"].at(0); }), "f:1:1: expected a member \"x\"");
  EXPECT_EQ(said([&] { return all["a"].size(); }), "f:2:1: a: expected a list, found an object");
  for (const char* text :
       {"", "{", "[1,]", "[1] 2", "{\"a\"}", "nul", "\"\\ud800\"", "[01]", "1e999", "{\"a\": 3,}", "{a: 3}",
        "{\"a\": [1, 2}", "[1.]", "[+1]", "[\"b\n\"]", "[\"\\x\"]", "[\"\\u12g4\"]", "[\"\xff\"]", "[\"\xc0\xaf\"]"})
    for (const bool strict : {false, true})
      EXPECT_NE(complaint(text, {.strict = strict}).find(": not JSON: "), std::string::npos) << text;
  const JsonLimits inside{.strict = false, .has_lines = false};
  EXPECT_EQ(refusal_of([&] { (void)parse_json("f.glb", "{\"a\":\n\"x\"}", inside)["a"].whole(); }),
            "f.glb: byte 6 of its JSON: a: expected a number, found \"x\"");
}

}  // namespace
}  // namespace restrip
