// Pluralised counts and sizes in messages.
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

/// 25888 as 25,888.
[[nodiscard]] inline std::string grouped(std::uint64_t number) {
  return number < 1000 ? std::to_string(number) : fmt::format("{},{:03}", grouped(number / 1000), number % 1000);
}

/// "1 rule", "25,888 rules".
[[nodiscard]] inline std::string counted_grouped(std::uint64_t number, std::string_view one) {
  return fmt::format("{} {}", grouped(number), plural(number, one));
}

/// A number of bytes in words: "16 GiB", "300 bytes".
[[nodiscard]] inline std::string size_in_words(std::uint64_t bytes) {
  constexpr std::uint64_t mib = std::uint64_t{1} << 20;
  if (bytes >= 1024 * mib && bytes % (1024 * mib) == 0) return fmt::format("{} GiB", bytes / (1024 * mib));
  if (bytes >= mib && bytes % mib == 0) return fmt::format("{} MiB", bytes / mib);
  return fmt::format("{} bytes", bytes);
}

}  // namespace restrip
