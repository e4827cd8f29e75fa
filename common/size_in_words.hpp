#pragma once
// Sizes in messages.

#include <fmt/format.h>

#include <cstdint>
#include <string>

namespace restrip::files {

/// A number of bytes in words: "16 GiB", "300 bytes".
[[nodiscard]] inline std::string size_in_words(std::uint64_t bytes) {
  constexpr std::uint64_t kib = 1024;
  if (bytes >= kib * kib * kib && bytes % (kib * kib * kib) == 0)
    return fmt::format("{} GiB", bytes / (kib * kib * kib));
  if (bytes >= kib * kib && bytes % (kib * kib) == 0) return fmt::format("{} MiB", bytes / (kib * kib));
  return fmt::format("{} bytes", bytes);
}

}  // namespace restrip::files
