#include "describe/formula.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <stdexcept>
#include <utility>

namespace restrip::generator {
namespace {

/// With constants of four digits no value overflows.
constexpr std::size_t most_terms_of_a_sum = 16;
constexpr std::size_t most_comparisons = 16;

/// Reads a formula of given numbers from left to right.
class FormulaReader {
 public:
  FormulaReader(std::string_view text, const std::vector<std::string>& numbers, std::string index = {})
      : text_(text), numbers_(numbers), index_(std::move(index)) {}

  /// term { ( "+" | "-" ) term }
  Sum sum() {
    Sum sum;
    add_term(sum, 1);
    for (std::size_t terms = 1;; ++terms) {
      if (terms > most_terms_of_a_sum)
        refuse(fmt::format("at most {} terms of a sum before this", most_terms_of_a_sum));
      if (taken("+"))
        add_term(sum, 1);
      else if (taken("-"))
        add_term(sum, -1);
      else
        return sum;
    }
  }

  [[noreturn]] void refuse(const std::string& expected) const {
    constexpr std::size_t shown = 100;
    throw std::runtime_error(fmt::format("\"{}{}\": expected {} in column {}", text_.substr(0, shown),
                                         text_.size() > shown ? "..." : "", expected, at_ + 1));
  }
  void expect_end() const {
    if (at_ != text_.size()) refuse("the end");
  }
  bool taken(std::string_view what) {
    skip_space();
    if (text_.substr(at_, what.size()) != what) return false;
    at_ += what.size();
    return true;
  }
  template <class Is>
  std::string run_of(Is&& is) {
    skip_space();
    const std::size_t start = at_;
    while (at_ < text_.size() && is(static_cast<unsigned char>(text_[at_])) != 0) ++at_;
    return std::string(text_.substr(start, at_ - start));
  }

 private:
  void skip_space() {
    while (at_ < text_.size() && text_[at_] == ' ') ++at_;
  }
  void add_term(Sum& sum, int sign) {
    const std::string digits = run_of([](int c) { return std::isdigit(c); });
    if (digits.size() > 4) refuse("a constant of four digits at most before this");
    const std::string name = run_of([](int c) { return std::isalpha(c); });
    const int factor = sign * (digits.empty() ? 1 : std::stoi(digits));
    const auto number = std::find(numbers_.begin(), numbers_.end(), name);
    if (name.empty() && !digits.empty())
      sum.constant += factor;
    else if (!name.empty() && name == index_)
      sum.of_index += factor;
    else if (number != numbers_.end())
      sum.factors.at(static_cast<std::size_t>(number - numbers_.begin())) += factor;
    else
      refuse("a number of the family or a constant before this");
  }

  std::string_view text_;
  const std::vector<std::string>& numbers_;
  std::string index_;
  std::size_t at_ = 0;
};

}  // namespace

int Sum::at(const PositionNumbers& place, int index) const {
  int sum = constant + of_index * index;
  for (std::size_t i = 0; i < place.size(); ++i) sum += factors[i] * static_cast<int>(place[i]);
  return sum;
}

bool hold(const Conditions& conditions, const PositionNumbers& place) {
  return std::all_of(conditions.begin(), conditions.end(), [&](const Comparison& comparison) {
    const int left = comparison.left.at(place);
    const int right = comparison.right.at(place);
    if (comparison.sign == "=") return left == right;
    if (comparison.sign == "<") return left < right;
    return comparison.sign == "<=" ? left <= right : left >= right;
  });
}

/// chain { "," chain }
Conditions parse_conditions(std::string_view text, const std::vector<std::string>& numbers) {
  FormulaReader in(text, numbers);
  const auto taken_sign = [&]() -> std::string {
    for (const char* sign : {"<=", ">=", "<", "="})
      if (in.taken(sign)) return sign;
    return {};
  };
  Conditions all;
  do {
    Sum left = in.sum();
    const std::size_t before = all.size();
    for (std::string sign = taken_sign(); !sign.empty(); sign = taken_sign()) {
      const Sum right = in.sum();
      all.push_back({left, sign, right});
      if (all.size() > most_comparisons) in.refuse(fmt::format("at most {} comparisons before this", most_comparisons));
      left = right;
    }
    if (all.size() == before) in.refuse("a comparison");
  } while (in.taken(","));
  in.expect_end();
  return all;
}

/// name [ "[" sum "," sum ")" ]
Stretch parse_stretch(std::string_view text, const std::vector<std::string>& numbers) {
  FormulaReader in(text, numbers);
  Stretch stretch{in.run_of([](int c) { return std::isalnum(c); }), {}};
  if (stretch.name.empty() || stretch.name.size() > longest_word)
    in.refuse(fmt::format("a name of 1 to {} letters and digits before this", longest_word));
  if (in.taken("[")) {
    stretch.range.emplace().from = in.sum();
    if (!in.taken(",")) in.refuse("\",\"");
    stretch.range->to = in.sum();
    if (!in.taken(")")) in.refuse("\")\" and the end");
  }
  in.expect_end();
  return stretch;
}

/// name [ "[" sum "]" ]
IndexedName parse_vertex(std::string_view text, const std::vector<std::string>& numbers, const std::string& index) {
  FormulaReader in(text, numbers, index);
  IndexedName vertex{in.run_of([](int c) { return static_cast<int>(std::isalnum(c) != 0 || c == '_'); }), {}};
  if (vertex.name.empty()) in.refuse("a name");
  if (in.taken("[")) {
    vertex.index = in.sum();
    if (!in.taken("]")) in.refuse("\"]\" and the end");
  }
  in.expect_end();
  return vertex;
}

}  // namespace restrip::generator
