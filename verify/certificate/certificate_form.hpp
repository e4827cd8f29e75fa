#pragma once
// What certificates of all kinds have in common: head, sections, claims, the last line with its sums
// (docs/reference/certificate.md). Whatever does not fit is an InputError that names file and line.

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

/// The first two lines of a certificate, and what comes behind them.
struct FormHead {
  std::string title;    ///< "restrip-certificate 3"
  std::string subject;  ///< "operation split"
  std::string first;    ///< what an error calls the third line: "a section"
};
FormHead head_of(const std::string& name);
/// "restrip-certificate 2", "family automaton".
FormHead family_head(const std::string& family);

/// Reads a certificate from its first line to its last. `read_body` finds the reader on the third line, leaves it on
/// the last one, and returns how many rows it has read.
void parse_form(const std::string& file, std::string text, const FormHead& head,
                const std::function<std::size_t(LineReader&)>& read_body);

/// The head of a section and its claims, those of `words` in this order. Leaves the reader on the first row; its first
/// word has to be one of `row_words`.
void parse_section_head(LineReader& reader, const std::string& position, std::span<const char* const> words,
                        std::span<StatedClaim> claims, std::span<const char* const> row_words);

/// The claims alone; the reader is on the first one, and is left behind the last one.
void parse_claims(LineReader& reader, std::span<const char* const> words, std::span<StatedClaim> claims);

}  // namespace restrip::verify
