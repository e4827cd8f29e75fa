#pragma once
// A certificate in memory, and its parser (docs/reference/certificate.md). The parser settles form: grammar, sections,
// claims and rows in order, sums. Whether a row is true is checked elsewhere.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "certificate/certificate_form.hpp"
#include "certificate/reason_text.hpp"
#include "model/family.hpp"
#include "model/key.hpp"

namespace restrip::verify {

struct Row {
  bool copy = false;
  Key key;
  Colors after;
  Permutation by;                ///< of a copy: where each port goes
  std::optional<Reason> reason;  ///< of a rule; all rules of a certificate have one, or none has
  unsigned line = 0;

  /// The row as the certificate writes it.
  std::string text() const;
};

inline constexpr std::array<const char*, 8> claim_words = {
    "configurations", "valid", "orbits", "valid-orbits", "keys", "costing", "worst-strips", "worst-isolated"};

struct SectionRows {
  std::array<StatedClaim, claim_words.size()> claims;
  std::vector<Row> rows;  ///< in ascending order of key

  /// Null when none exists.
  const Row* row_of(Key key) const;
};

struct Certificate {
  std::string file;
  std::vector<SectionRows> sections;  ///< one for each section of the family, in the same order
  std::size_t rows = 0;
};

/// InputError when anything is not as docs/reference/certificate.md says.
Certificate parse_certificate(const std::string& file, std::string text, const Family& family);

/// The rows of a section; leaves the reader on the first line behind them. All rules of a certificate have a reason, or
/// none has.
void parse_rows(LineReader& reader, const Section& section, const Certificate& certificate, SectionRows& result);

/// Rows come in ascending order, each key once.
void expect_order(const LineReader& reader, const std::vector<Row>& rows, const Row& row);

}  // namespace restrip::verify
