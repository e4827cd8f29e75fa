// The stage `emit` of the generator's path: text of the generated constexpr headers. Same input, same bytes.
#pragma once

#include <string>
#include <vector>

#include "tables/certificate_text.hpp"
#include "tables/packing.hpp"

namespace restrip::generator {

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
[[nodiscard]] RulesHeader rules_header(const Certificate& family, const Packing& packing, unsigned max_k);

/// restrip/tables/linked.hpp: the lists of all families that have some.
[[nodiscard]] RulesHeader linked_header(const std::vector<Certificate>& families, unsigned max_k);

}  // namespace restrip::generator
