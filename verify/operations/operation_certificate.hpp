#pragma once
// The certificate of an operation in memory, and its parser (docs/operation-file.md, "Certificate"). The parser settles
// form: grammar, claims and rows in order, sums. Whether a row is true is checked elsewhere.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "certificate_form.hpp"
#include "patch_symmetry.hpp"
#include "reason_text.hpp"

namespace restrip::verify::operations {

struct RuleRow {
  bool copy = false;
  OperationKey key;
  Colors after;
  Permutation by;                ///< of a copy: where each port goes
  std::optional<Reason> reason;  ///< of a rule; all rules have one, or none has
  unsigned line = 0;

  /// The row as the certificate writes it.
  std::string text() const;
};

inline constexpr std::array<const char*, 8> number_words = {
    "configurations", "valid", "orbits", "valid-orbits", "keys", "costing", "worst-strips", "worst-isolated"};

struct OperationCertificate {
  std::string file;
  std::array<StatedClaim, number_words.size()> claims;
  std::vector<RuleRow> rows;  ///< in ascending order of key

  /// Null when there is none.
  const RuleRow* row_of(OperationKey key) const;
};

/// InputError when anything is not as docs/operation-file.md says.
OperationCertificate parse_operation_certificate(const std::string& file, std::string text,
                                                 const OperationFile& operation);

}  // namespace restrip::verify::operations
