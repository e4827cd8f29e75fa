#pragma once
// A certificate in memory, and its parser (docs/certificate.md). The parser settles form: grammar, sections, order,
// duplicates, number of rows. Whether a row is true is checked elsewhere.

#include <array>
#include <string>
#include <vector>

#include "certificate_form.hpp"
#include "reason_text.hpp"
#include "symmetry.hpp"

namespace restrip::verify {

struct Row {
  bool copy = false;
  Key key;
  Coloring after;   ///< of a fan family: with the ports of the key
  PortSymmetry by;  ///< of a copy
  Reason reason;    ///< of a rule
  unsigned line = 0;
};

inline constexpr std::array<const char*, 7> claim_words = {
    "configurations", "valid", "orbits", "valid-orbits", "costing", "worst-strips", "worst-isolated"};

struct SectionRows {
  std::array<StatedClaim, claim_words.size()> claims;
  std::vector<Row> rows;  ///< in ascending order of key
};

struct Certificate {
  std::string file;
  std::vector<SectionRows> sections;  ///< one for each section of the family, in the same order
  std::size_t rows = 0;
};

/// InputError when anything is not as docs/certificate.md says.
Certificate parse_certificate(const std::string& file, std::string text, const Family& family);

/// The row as the certificate writes it.
std::string text_of(const Row& row, bool gives_ports_up);

}  // namespace restrip::verify
