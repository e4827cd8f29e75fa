#pragma once
// What certificates of all kinds have in common: head, sections, claims, the last line with its sums
// (docs/certificate.md). Whatever does not fit is an InputError that names file and line.

#include <cstdint>
#include <functional>
#include <span>
#include <string>

#include "input.hpp"

namespace restrip::verify {

struct StatedClaim {
  std::int64_t number = 0;
  unsigned line = 0;
};

/// Reads a certificate from its first line to its last. `read_sections` finds the reader on the first section's head,
/// leaves it on the last line, and returns how many rows it has read.
void parse_form(const std::string& file, std::string text, const std::string& family,
                const std::function<std::size_t(LineReader&)>& read_sections);

/// The head of a section and its claims, each of `words` once. Leaves the reader on the first row; its first word has
/// to be one of `row_words`.
void parse_section_head(LineReader& reader, const std::string& position, std::span<const char* const> words,
                        std::span<StatedClaim> claims, std::span<const char* const> row_words);

}  // namespace restrip::verify
