#pragma once
// The two sums at the end of a certificate. They detect any single altered byte, however plausible the altered file
// looks.

#include <cstdint>
#include <optional>
#include <string_view>

namespace restrip::verify {

/// Sums of bytes as numbers 0 … 255.
struct ByteSums {
  std::uint64_t plain = 0;
  std::uint64_t weighted = 0;  ///< each byte times its number; the first byte has number 1
  friend constexpr bool operator==(const ByteSums&, const ByteSums&) = default;
};

ByteSums sums_of(std::string_view bytes);

struct BytePosition {
  unsigned line = 0;  ///< from 1
  unsigned byte = 0;  ///< in its line, from 1; the newline is the last
};

/// The position of a single altered byte, derived from the last line; nullopt if it is unknown: the file is intact or
/// several bytes were altered.
std::optional<BytePosition> altered_byte(std::string_view certificate);

}  // namespace restrip::verify
