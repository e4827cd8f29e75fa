#include "common/size_in_words.hpp"

#include <fmt/format.h>

namespace restrip::files {

std::string size_in_words(std::uint64_t bytes) {
  constexpr std::uint64_t kib = 1024;
  if (bytes >= kib * kib * kib && bytes % (kib * kib * kib) == 0)
    return fmt::format("{} GiB", bytes / (kib * kib * kib));
  if (bytes >= kib * kib && bytes % (kib * kib) == 0) return fmt::format("{} MiB", bytes / (kib * kib));
  return fmt::format("{} bytes", bytes);
}

}  // namespace restrip::files
