#pragma once
// A certificate of linked rules in memory, and its parser (docs/reference/certificate.md, "Linked rules").

#include <array>
#include <span>
#include <string>
#include <vector>

#include "certificate/certificate_form.hpp"
#include "model/family.hpp"

namespace restrip::verify {

/// One row: a recolouring in the list of its ports.
struct Alternative {
  Mask ports = 0;
  Mask inner = 0;
  unsigned line = 0;

  /// The alternative as the certificate writes it.
  std::string text() const;
};

using List = std::span<const Alternative>;

inline constexpr std::array<const char*, 3> linked_claim_words = {"lists", "alternatives", "longest"};

struct SectionLists {
  std::array<StatedClaim, linked_claim_words.size()> claims;
  std::vector<Alternative> rows;  ///< in ascending order of ports

  /// Empty if the section has none for these ports.
  List list(Mask ports) const;
};

struct LinkedCertificate {
  std::string file;
  std::vector<SectionLists> sections;  ///< one for each section of the family, in the same order
  std::size_t rows = 0;
};

/// Throws InputError if anything differs from docs/reference/certificate.md.
LinkedCertificate parse_linked_certificate(const std::string& file, std::string text, const LinkedFamily& family);

}  // namespace restrip::verify
