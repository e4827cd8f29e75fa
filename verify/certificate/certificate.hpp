// A certificate in memory, and its parser (docs/reference/certificate.md). The parser checks form: grammar, sections,
// claims and rows in order, sums. The truth of rows is checked elsewhere.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "certificate/certificate_form.hpp"
#include "model/family.hpp"
#include "model/key.hpp"

namespace restrip::verify {

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
