// The stage `emit` of the generator's pipeline: text of the generated constexpr headers. Same input, same bytes.
#pragma once

#include <string>
#include <vector>

#include "tables/certificate_text.hpp"
#include "tables/packing.hpp"

namespace restrip::generator {

/// A family's name with underscores, as used in programs and file names.
[[nodiscard]] std::string identifier(std::string name);

/// restrip/tables/rows.hpp: the start of the rows of keys.
[[nodiscard]] std::string rows_header(const Packing& packing, unsigned max_k);

/// A header and the size of its read-only data.
struct RulesHeader {
  std::string text;
  std::size_t bytes = 0;
};

/// restrip/tables/FAMILY.hpp.
[[nodiscard]] RulesHeader rules_header(const Certificate& family, const Packing& packing, unsigned max_k);

}  // namespace restrip::generator
