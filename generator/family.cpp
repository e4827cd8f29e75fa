#include "family.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string_view>

#include "families_text.hpp"

namespace restrip::generator {
namespace {

using Json = nlohmann::json;

/// Reads a formula of certain numbers from left to right.
class FormulaReader {
 public:
  FormulaReader(std::string_view text, const std::vector<std::string>& numbers) : text_(text), numbers_(numbers) {}

  /// term { "+" term }
  Sum sum() {
    Sum sum;
    do add_term(sum);
    while (taken("+"));
    return sum;
  }

  /// chain { "," chain }
  Conditions conditions() {
    Conditions all;
    do {
      Sum left = sum();
      const std::size_t before = all.size();
      for (std::string sign = this->sign(); !sign.empty(); sign = this->sign()) {
        const Sum right = sum();
        all.push_back({left, sign, right});
        left = right;
      }
      if (all.size() == before) refuse("a comparison");
    } while (taken(","));
    if (at_ != text_.size()) refuse("the end");
    return all;
  }

  /// "t[" sum "," sum ")", or a name.
  Stretch stretch() {
    if (!taken("t[")) return {std::string(text_), {}, {}};
    Stretch stretch{"t", sum(), {}};
    if (!taken(",")) refuse("\",\"");
    stretch.to = sum();
    if (!taken(")") || at_ != text_.size()) refuse("\")\" and the end");
    return stretch;
  }

 private:
  [[noreturn]] void refuse(const std::string& expected) const {
    throw std::runtime_error(fmt::format("\"{}\": expected {} in column {}", text_, expected, at_ + 1));
  }
  void skip_space() {
    while (at_ < text_.size() && text_[at_] == ' ') ++at_;
  }
  bool taken(std::string_view what) {
    skip_space();
    if (text_.substr(at_, what.size()) != what) return false;
    at_ += what.size();
    return true;
  }
  std::string sign() {
    for (const char* sign : {"<=", ">=", "<", "="})
      if (taken(sign)) return sign;
    return {};
  }
  template <class Is>
  std::string run_of(Is&& is) {
    skip_space();
    const std::size_t start = at_;
    while (at_ < text_.size() && is(static_cast<unsigned char>(text_[at_])) != 0) ++at_;
    return std::string(text_.substr(start, at_ - start));
  }
  void add_term(Sum& sum) {
    const std::string digits = run_of([](int c) { return std::isdigit(c); });
    const std::string name = run_of([](int c) { return std::isalpha(c); });
    const unsigned factor = digits.empty() ? 1 : static_cast<unsigned>(std::stoul(digits));
    const auto number = std::find(numbers_.begin(), numbers_.end(), name);
    if (name.empty() && !digits.empty())
      sum.constant += factor;
    else if (number != numbers_.end())
      sum.factors.at(static_cast<std::size_t>(number - numbers_.begin())) += factor;
    else
      refuse("a number of the family or a constant before this");
  }

  std::string_view text_;
  const std::vector<std::string>& numbers_;
  std::size_t at_ = 0;
};

void expect_members(const Json& json, const std::vector<std::string>& known) {
  for (const auto& [member, value] : json.items())
    if (std::find(known.begin(), known.end(), member) == known.end())
      throw std::runtime_error(fmt::format("\"{}\": unknown member, expected {}", member, fmt::join(known, ", ")));
}

SidePattern side_from(const Json& json, const std::vector<std::string>& numbers) {
  expect_members(json, {"ring", "path", "chord", "ports"});
  SidePattern side;
  side.ring = json.contains("ring");
  for (const std::string text : json.at(side.ring ? "ring" : "path"))
    side.stretches.push_back(FormulaReader(text, numbers).stretch());
  side.chord = json.value("chord", side.chord);
  if (!side.chord.empty() && side.chord.size() != 2) throw std::runtime_error("\"chord\": expected two triangles");
  side.ports = json.value("ports", side.ports);
  return side;
}

bool chosen(const Json& json, const std::string& member, const std::string& usual, const std::string& other) {
  const std::string word = json.value(member, usual);
  if (word != usual && word != other)
    throw std::runtime_error(fmt::format("\"{}\": expected \"{}\" or \"{}\"", member, usual, other));
  return word == other;
}

Family family_from(const Json& json) {
  // `at_most` is what the verifier holds the rules against; `position` is for its reports.
  expect_members(json, {"name", "about", "certificate", "numbers", "where", "listed", "position", "section", "key",
                        "give_up", "before", "after", "linked", "at_most"});
  Family family;
  family.name = json.at("name");
  family.certificate = json.value("certificate", family.name);
  family.numbers = json.value("numbers", family.numbers);
  if (family.numbers.size() > PositionNumbers{}.size()) throw std::runtime_error("\"numbers\": expected three at most");
  family.range = json.value("where", "");
  if (json.contains("where")) family.where = FormulaReader(family.range, family.numbers).conditions();
  const std::string listed = json.value("listed", "");
  if (json.contains("listed")) family.listed = FormulaReader(listed, family.numbers).conditions();
  family.section = json.value("section", json.value("position", ""));
  family.keyed_by_inner = chosen(json, "key", "joined", "inner");
  family.gives_ports_up = chosen(json, "give_up", "none", "all");
  family.linked = json.value("linked", false);
  family.before = side_from(json.at("before"), family.numbers);
  family.after = side_from(json.at("after"), family.numbers);
  return family;
}

}  // namespace

unsigned Sum::at(const PositionNumbers& numbers) const {
  unsigned sum = constant;
  for (std::size_t i = 0; i < numbers.size(); ++i) sum += factors[i] * numbers[i];
  return sum;
}

bool hold(const Conditions& conditions, const PositionNumbers& numbers) {
  return std::all_of(conditions.begin(), conditions.end(), [&](const Comparison& comparison) {
    const unsigned left = comparison.left.at(numbers);
    const unsigned right = comparison.right.at(numbers);
    if (comparison.sign == "=") return left == right;
    if (comparison.sign == "<") return left < right;
    return comparison.sign == "<=" ? left <= right : left >= right;
  });
}

std::vector<Family> parse_families(std::string_view text) {
  try {
    if (text.starts_with("\xef\xbb\xbf"))  // which the parser would skip
      throw std::runtime_error("begins with a byte order mark; save it as UTF-8 without one");
    const Json json = Json::parse(text);
    expect_members(json, {"restrip_families", "families"});
    if (json.at("restrip_families") != 1) throw std::runtime_error("\"restrip_families\": expected version 1");
    std::vector<Family> families;
    for (const Json& family : json.at("families")) families.push_back(family_from(family));
    return families;
  } catch (const std::exception& error) {
    throw std::runtime_error(fmt::format("tables/families.json: {}", error.what()));
  }
}

const std::vector<Family>& families() {
  static const std::vector<Family> all = parse_families(families_text);
  return all;
}

const Family& family_named(const std::string& name) {
  for (const Family& family : families())
    if (family.name == name) return family;
  throw std::invalid_argument("no family is named " + name);
}

}  // namespace restrip::generator
