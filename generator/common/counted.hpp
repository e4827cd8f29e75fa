// Numbers of things in messages.
#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <string>
#include <string_view>

namespace restrip::generator {

/// "strip" or "strips": one of them, or another number.
[[nodiscard]] inline std::string plural(std::uint64_t count, std::string_view thing) {
  return fmt::format("{}{}", thing, count == 1 ? "" : "s");
}

/// "1 strip", "2 strips".
[[nodiscard]] inline std::string counted(std::uint64_t count, std::string_view thing) {
  return fmt::format("{} {}", count, plural(count, thing));
}

}  // namespace restrip::generator
