#pragma once
// The two sums that end a certificate: with them a single altered byte gives itself away, wherever it is and however
// right the altered file may look.

#include <cstdint>
#include <optional>
#include <string_view>

namespace restrip::verify {

/// Of bytes taken as numbers 0 … 255.
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

/// Where a single byte of a certificate must have been altered, by what its last line states; nullopt when that cannot
/// be told, as with an intact file or more than one altered byte.
std::optional<BytePosition> altered_byte(std::string_view certificate);

}  // namespace restrip::verify
