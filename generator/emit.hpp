// Text of the generated files: constexpr headers and certificates. Same input, same bytes.
#pragma once

#include <string>
#include <vector>

#include "linked.hpp"
#include "packing.hpp"
#include "section.hpp"

namespace restrip::generator {

/// A certificate's family with its sections.
struct SolvedFamily {
  std::string name;
  std::vector<Section> sections;
  [[nodiscard]] std::size_t rows() const;
};

/// restrip/tables/rows.hpp: where the rows of keys start, for closed and open fans.
[[nodiscard]] std::string rows_header(const Packing& closed, const Packing& open, unsigned max_k);

/// A header and the read-only data that it compiles to.
struct RulesHeader {
  std::string text;
  std::size_t bytes = 0;
};

/// restrip/tables/FAMILY.hpp.
[[nodiscard]] RulesHeader rules_header(const SolvedFamily& family, const Packing& packing, unsigned max_k);

/// A family's linked rules.
struct LinkedFamily {
  std::string name;
  std::vector<LinkedSection> sections;
  [[nodiscard]] std::size_t alternatives() const;
};

/// restrip/tables/linked.hpp: the lists of all families.
[[nodiscard]] RulesHeader linked_header(const std::vector<LinkedFamily>& families, unsigned max_k);

/// certificates/FAMILY.cert (docs/certificate.md).
[[nodiscard]] std::string certificate(const SolvedFamily& family);

/// certificates/linked-FAMILY.cert.
[[nodiscard]] std::string linked_certificate(const LinkedFamily& family);

}  // namespace restrip::generator
