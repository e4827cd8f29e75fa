// Text of the generated files: constexpr headers and certificates. Same input, same bytes.
#pragma once

#include <string>
#include <vector>

#include "solve/section.hpp"
#include "tables/packing.hpp"

namespace restrip::generator {

/// A certificate with its sections, solved, rules or linked ones.
struct SolvedFamily {
  std::string name;
  std::vector<Section> sections;
  [[nodiscard]] std::size_t rows() const;
  [[nodiscard]] bool linked() const { return sections.at(0).linked; }
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

/// restrip/tables/linked.hpp: the lists of all families that have some.
[[nodiscard]] RulesHeader linked_header(const std::vector<SolvedFamily>& families, unsigned max_k);

/// certificates/NAME.cert from the texts of its sections.
[[nodiscard]] std::string certificate(const SolvedFamily& family);

}  // namespace restrip::generator
