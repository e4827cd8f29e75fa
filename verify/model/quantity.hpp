#pragma once
// Pluralised counts for reports.

#include <fmt/format.h>

#include <cstdint>
#include <string>
#include <string_view>

namespace restrip::verify {

/// 25888 as 25,888.
inline std::string grouped(std::uint64_t number) {
  return number < 1000 ? std::to_string(number) : fmt::format("{},{:03}", grouped(number / 1000), number % 1000);
}

/// "1 rule", "2 rules"; without commas in the number.
inline std::string quantity(std::uint64_t number, std::string_view one, std::string_view ending = "s") {
  return fmt::format("{} {}{}", number, one, number == 1 ? "" : ending);
}

/// "1 rule", "25,888 rules".
inline std::string quantity_grouped(std::uint64_t number, std::string_view one) {
  return fmt::format("{} {}{}", grouped(number), one, number == 1 ? "" : "s");
}

}  // namespace restrip::verify
