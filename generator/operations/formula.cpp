#include "operations/formula.hpp"

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

  /// chain { "," chain }
  Conditions conditions() {
    Conditions all;
    do {
      Sum left = sum();
      const std::size_t before = all.size();
      for (std::string sign = this->sign(); !sign.empty(); sign = this->sign()) {
        const Sum right = sum();
        all.push_back({left, sign, right});
        if (all.size() > most_comparisons) refuse(fmt::format("at most {} comparisons before this", most_comparisons));
        left = right;
      }
      if (all.size() == before) refuse("a comparison");
    } while (taken(","));
    if (at_ != text_.size()) refuse("the end");
    return all;
  }

  /// name [ "[" sum "," sum ")" ]
  Stretch stretch() {
    Stretch stretch{run_of([](int c) { return std::isalnum(c); }), {}};
    if (stretch.name.empty() || stretch.name.size() > longest_word)
      refuse(fmt::format("a name of 1 to {} letters and digits before this", longest_word));
    if (taken("[")) {
      stretch.range.emplace().from = sum();
      if (!taken(",")) refuse("\",\"");
      stretch.range->to = sum();
      if (!taken(")")) refuse("\")\" and the end");
    }
    if (at_ != text_.size()) refuse("the end");
    return stretch;
  }

  /// name [ "[" sum "]" ]
  IndexedName vertex() {
    IndexedName vertex{run_of([](int c) { return static_cast<int>(std::isalnum(c) != 0 || c == '_'); }), {}};
    if (vertex.name.empty()) refuse("a name");
    if (taken("[")) {
      vertex.index = sum();
      if (!taken("]")) refuse("\"]\" and the end");
    }
    if (at_ != text_.size()) refuse("the end");
    return vertex;
  }

 private:
  [[noreturn]] void refuse(const std::string& expected) const {
    constexpr std::size_t shown = 100;
    throw std::runtime_error(fmt::format("\"{}{}\": expected {} in column {}", text_.substr(0, shown),
                                         text_.size() > shown ? "..." : "", expected, at_ + 1));
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

Conditions parse_conditions(std::string_view text, const std::vector<std::string>& numbers) {
  return FormulaReader(text, numbers).conditions();
}

Stretch parse_stretch(std::string_view text, const std::vector<std::string>& numbers) {
  return FormulaReader(text, numbers).stretch();
}

IndexedName parse_vertex(std::string_view text, const std::vector<std::string>& numbers, const std::string& index) {
  return FormulaReader(text, numbers, index).vertex();
}

}  // namespace restrip::generator
