#pragma once
// The common parts of all certificates: head, sections, claims, the last line with its sums
// (docs/reference/certificate.md). Any deviation is an InputError that names file and line.

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

/// The first two lines of a certificate, and a description of what follows.
struct FormHead {
  std::string title;    ///< "restrip-certificate 3"
  std::string subject;  ///< "operation split"
  std::string first;    ///< the name of the third line in errors: "a section"
};
FormHead head_of(const std::string& name);
/// "restrip-certificate 2", "family automaton".
FormHead family_head(const std::string& family);

/// Reads a certificate from its first line to its last. `read_body` starts on the third line, leaves the reader on the
/// last one, and returns the number of rows.
void parse_form(const std::string& file, std::string text, const FormHead& head,
                const std::function<std::size_t(LineReader&)>& read_body);

/// Reads the head of a section and its claims `words`, in this order. Leaves the reader on the first row, whose first
/// word must be one of `row_words`.
void parse_section_head(LineReader& reader, const std::string& position, std::span<const char* const> words,
                        std::span<StatedClaim> claims, std::span<const char* const> row_words);

/// Reads the claims alone, from the first one to the line after the last.
void parse_claims(LineReader& reader, std::span<const char* const> words, std::span<StatedClaim> claims);

}  // namespace restrip::verify
