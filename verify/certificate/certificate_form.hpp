#pragma once
// The common parts of all certificates: head, sections, claims, the last line with its sums
// (docs/reference/certificate.md). Any deviation is an InputError that names file and line.

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <string>

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

}  // namespace restrip::verify
