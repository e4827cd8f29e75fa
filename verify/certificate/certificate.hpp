// A certificate in memory, and its parser (docs/reference/certificate.md). The parser checks form: grammar, sections,
// claims and rows in order, sums. The truth of rows is checked elsewhere.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "model/description.hpp"
#include "model/input.hpp"
#include "model/masks.hpp"

namespace restrip::verify {

// The common parts of all certificates: head, sections, claims, the last line with its sums
// (docs/reference/certificate.md). Any deviation is an InputError that names file and line.

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

/// Why no recolouring is preferred to a rule: either two cases (an edge solid, and the same edge dashed), or sets of
/// edges that cannot all be solid.
struct Reason {
  unsigned edge = 0;
  std::vector<Reason> cases;  ///< solid, dashed; empty for a leaf
  std::vector<Mask> sets;     ///< of a leaf

  /// The reason as the certificate writes it (docs/reference/certificate.md, "Reasons").
  std::string text() const;
  /// The number of leaves of its tree.
  std::size_t leaves() const { return cases.empty() ? 1 : cases[0].leaves() + cases[1].leaves(); }
};

struct Row {
  bool copy = false;
  Key key;
  Colors after;
  Permutation by;                ///< of a copy: the destination of each port
  std::optional<Reason> reason;  ///< of a rule; all rules of a certificate have one, or none
  unsigned line = 0;

  /// The row as the certificate writes it.
  std::string text() const;
};

inline constexpr std::array<const char*, 8> claim_words = {
    "configurations", "valid", "orbits", "valid-orbits", "keys", "costing", "worst-strips", "worst-isolated"};

struct SectionRows {
  std::array<StatedClaim, claim_words.size()> claims;
  std::vector<Row> rows;  ///< in ascending order of key

  /// Null if the key has no row.
  const Row* row_of(Key key) const;
};

struct Certificate {
  std::string file;
  std::vector<SectionRows> sections;  ///< one for each section of the family, in the same order
  std::size_t rows = 0;
};

/// Throws InputError if anything differs from docs/reference/certificate.md.
Certificate parse_certificate(const std::string& file, std::string text, const Family& family);

}  // namespace restrip::verify
