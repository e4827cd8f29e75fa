// The common parts of all certificates: head, sections, claims, the last line with its sums
// (docs/reference/certificate.md). Any deviation is an InputError that names file and line.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "model/input.hpp"

namespace restrip::verify {

struct StatedClaim {
  std::int64_t number = 0;
  unsigned line = 0;
};

/// Reads a certificate from its first line to its last; `head` are the first two. `read_body` starts on the third line,
/// leaves the reader on the last one, and returns the number of rows.
void parse_form(const std::string& file, std::string text, const std::array<std::string, 2>& head,
                const std::function<std::size_t(LineReader&)>& read_body);

/// Reads the head of a section and its claims `words`, in this order. Leaves the reader on the first row, whose first
/// word must be one of `row_words`.
void parse_section_head(LineReader& reader, const std::string& position, std::span<const char* const> words,
                        std::span<StatedClaim> claims, std::span<const char* const> row_words);

// ---- the two sums at the end of a certificate, which detect any single altered byte, however plausible the altered
// file looks

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
