// Counts as English says them.
#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <string>
#include <string_view>

namespace restrip::tools {

/// "0 strips", "1 strip", "2 strips". `many` is for words of which an s does not make the plural, and for those that
/// bring their verb: counted(n, "edge lies", "edges lie").
[[nodiscard]] inline std::string counted(std::size_t count, std::string_view one, std::string_view many = {}) {
  if (count == 1) return fmt::format("1 {}", one);
  return many.empty() ? fmt::format("{} {}s", count, one) : fmt::format("{} {}", count, many);
}

}  // namespace restrip::tools
