#include "formula.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <stdexcept>

#include "mutants.hpp"

namespace restrip::verify {
namespace {

constexpr std::array<std::string_view, 4> signs = {"<=", ">=", "<", "="};  // none is the beginning of a later one

std::string_view trimmed(std::string_view text) {
  while (text.starts_with(' ')) text.remove_prefix(1);
  while (text.ends_with(' ')) text.remove_suffix(1);
  return text;
}

/// What lies between separators, without spaces around it.
std::vector<std::string_view> parts_of(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  while (true) {
    const std::size_t end = std::min(text.find(separator), text.size());
    parts.push_back(trimmed(text.substr(0, end)));
    if (end == text.size()) return parts;
    text.remove_prefix(end + 1);
  }
}

}  // namespace

Sum::Sum(std::string_view text, const std::vector<std::string>& names) : factors_(names.size()) {
  for (const std::string_view term : parts_of(text, '+')) {
    unsigned factor = 1;
    const auto [end, error] = std::from_chars(term.data(), term.data() + term.size(), factor);
    const bool has_factor = error == std::errc{};
    const std::string_view name = trimmed(term.substr(static_cast<std::size_t>(end - term.data())));
    if (has_factor && name.empty()) {
      constant_ += factor;
      continue;
    }
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end())
      throw std::invalid_argument(fmt::format("expected a sum of {}, found \"{}\"", fmt::join(names, ", "), text));
    factors_[static_cast<std::size_t>(found - names.begin())] += factor;
  }
}

unsigned Sum::of(const Numbers& numbers) const {
  unsigned sum = constant_;
  for (std::size_t i = 0; i < factors_.size(); ++i) sum += factors_[i] * numbers.at(i);
  return sum;
}

Conditions::Conditions(std::string_view text, const std::vector<std::string>& names) {
  for (std::string_view chain : parts_of(text, ',')) {
    const std::size_t before = all_.size();
    std::string_view left;
    std::string_view sign;
    while (true) {
      const std::size_t at = std::min(chain.find_first_of("<>="), chain.size());
      const std::string_view right = trimmed(chain.substr(0, at));
      if (!sign.empty()) all_.push_back({Sum(left, names), sign, Sum(right, names)});
      if (at == chain.size()) break;
      const auto* const found = std::find_if(signs.begin(), signs.end(),
                                             [&](std::string_view one) { return chain.substr(at).starts_with(one); });
      if (found == signs.end()) throw std::invalid_argument(fmt::format("expected <, <=, >= or = in \"{}\"", text));
      left = right;
      sign = *found;
      chain.remove_prefix(at + sign.size());
    }
    if (all_.size() == before) throw std::invalid_argument(fmt::format("expected a comparison, found \"{}\"", text));
  }
}

bool Conditions::hold(const Numbers& numbers) const {
  return std::all_of(all_.begin(), all_.end(), [&](const Comparison& comparison) {
    const unsigned left = comparison.left.of(numbers);
    const unsigned right = comparison.right.of(numbers);
    if (comparison.sign == "<=" && !mutated(Mutant::at_most_less)) return left <= right;
    if (comparison.sign == ">=") return left >= right;
    return comparison.sign == "=" ? left == right : left < right;
  });
}

}  // namespace restrip::verify
