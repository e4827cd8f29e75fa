// Pluralised counts in messages.
#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <string>
#include <string_view>

namespace restrip {

/// "strip" for 1, "strips" for any other number. `many` is the plural if it does not end in -s, or contains a verb:
/// plural(n, "edge lies", "edges lie").
[[nodiscard]] inline std::string plural(std::uint64_t count, std::string_view one, std::string_view many = {}) {
  if (count == 1) return std::string(one);
  return many.empty() ? fmt::format("{}s", one) : std::string(many);
}

/// "0 strips", "1 strip", "2 strips".
[[nodiscard]] inline std::string counted(std::uint64_t count, std::string_view one, std::string_view many = {}) {
  return fmt::format("{} {}", count, plural(count, one, many));
}

}  // namespace restrip
