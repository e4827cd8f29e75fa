#include "model/formula.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <stdexcept>

namespace restrip::verify {
namespace {

// Limits of docs/reference/operation-file.md.
constexpr std::size_t most_terms_of_a_sum = 16;
constexpr std::size_t most_comparisons = 16;

constexpr std::array<std::string_view, 4> signs = {"<=", ">=", "<", "="};  // none is a prefix of a later one

std::string_view trimmed(std::string_view text) {
  while (text.starts_with(' ')) text.remove_prefix(1);
  while (text.ends_with(' ')) text.remove_suffix(1);
  return text;
}

/// The parts between separators, without surrounding spaces.
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
  constexpr std::size_t most_digits = 4;
  std::int64_t sign = 1;
  std::size_t terms = 0;
  for (std::string_view rest = text;;) {
    if (++terms > most_terms_of_a_sum)
      throw std::invalid_argument(
          fmt::format("expected a sum of at most {} terms, found \"{}\"", most_terms_of_a_sum, text));
    const std::size_t next = std::min(rest.find_first_of("+-"), rest.size());
    const std::string_view term = trimmed(rest.substr(0, next));
    const std::size_t digits = std::min(term.find_first_not_of("0123456789"), term.size());
    const std::string_view name = trimmed(term.substr(digits));
    const auto found = std::find(names.begin(), names.end(), name);
    const bool is_constant = digits != 0 && name.empty();
    if (digits > most_digits || (!is_constant && found == names.end()))
      throw std::invalid_argument(fmt::format("expected a sum of {}, found \"{}\"", fmt::join(names, ", "), text));
    std::int64_t factor = 1;
    if (digits != 0) std::from_chars(term.data(), term.data() + digits, factor);
    (is_constant ? constant_ : factors_[static_cast<std::size_t>(found - names.begin())]) += sign * factor;
    if (next == rest.size()) return;
    sign = rest[next] == '-' ? -1 : 1;
    rest.remove_prefix(next + 1);
  }
}

std::int64_t Sum::of(const Numbers& numbers) const {
  std::int64_t sum = constant_;
  for (std::size_t i = 0; i < factors_.size(); ++i) sum += factors_[i] * std::int64_t{numbers.at(i)};
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
      if (all_.size() > most_comparisons)
        throw std::invalid_argument(
            fmt::format("expected at most {} comparisons, found \"{}\"", most_comparisons, text));
      if (at == chain.size()) break;
      const auto found = std::find_if(signs.begin(), signs.end(),
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
    const std::int64_t left = comparison.left.of(numbers);
    const std::int64_t right = comparison.right.of(numbers);
    if (comparison.sign == "<=") return left <= right;
    if (comparison.sign == ">=") return left >= right;
    return comparison.sign == "=" ? left == right : left < right;
  });
}

}  // namespace restrip::verify
