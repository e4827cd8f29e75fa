#pragma once
// Sizes in messages.

#include <cstdint>
#include <string>

namespace restrip::files {

/// A number of bytes in words: "16 GiB", "300 bytes".
[[nodiscard]] std::string size_in_words(std::uint64_t bytes);

}  // namespace restrip::files
