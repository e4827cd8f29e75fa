// Text of the generated files: constexpr headers and certificates. Same input, same bytes.
#pragma once

#include <string>
#include <vector>

#include "linked.hpp"
#include "packing.hpp"
#include "section.hpp"

namespace restrip::generator {

/// A certificate with its last line: how many rows, and two sums of its bytes from which a reader can tell which single
/// byte was altered.
[[nodiscard]] std::string sealed(std::string text, std::size_t rows);

/// A certificate's family with its sections.
struct SolvedFamily {
  std::string name;
  std::vector<Section> sections;
  std::vector<std::string> texts;  ///< of the sections, as certificates write them
  [[nodiscard]] std::size_t rows() const;
};

/// A family's name as programs and files spell it: with underscores.
[[nodiscard]] std::string identifier(std::string name);

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
  std::vector<std::string> texts;  ///< of the sections, as certificates write them
  [[nodiscard]] std::size_t alternatives() const;
};

/// restrip/tables/linked.hpp: the lists of all families.
[[nodiscard]] RulesHeader linked_header(const std::vector<LinkedFamily>& families, unsigned max_k);

/// A position as certificates write it, after the word `section`.
[[nodiscard]] std::string position_text(const Position& position);

/// A solved section as certificates write it, with claims, rows and reasons (docs/certificate.md).
[[nodiscard]] std::string section_text(const Section& section);
[[nodiscard]] std::string section_text(const LinkedSection& section);

/// certificates/FAMILY.cert from the texts of its sections.
[[nodiscard]] std::string certificate(const std::string& family, const std::vector<std::string>& texts,
                                      std::size_t rows);

}  // namespace restrip::generator
