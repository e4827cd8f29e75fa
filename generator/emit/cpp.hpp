// The generated constexpr headers. Same input, same bytes.
#pragma once

#include <cstddef>
#include <string>

#include "automaton/automaton_layout.hpp"
#include "tables/operation_layout.hpp"
#include "tables/packing.hpp"

namespace restrip::generator {

/// restrip/tables/rows.hpp: the start of the rows of keys.
[[nodiscard]] std::string rows_header(const Packing& packing, unsigned max_k);

/// A header and the size of its read-only data.
struct RulesHeader {
  std::string text;
  std::size_t bytes = 0;
};

/// restrip/tables/FAMILY.hpp.
[[nodiscard]] RulesHeader rules_header(const Certificate& family, const Packing& packing, unsigned max_k);

/// restrip/tables/automaton.hpp.
[[nodiscard]] RulesHeader automaton_header(const Automaton& automaton);

/// restrip/tables/operations/NAME.hpp: docs/reference/operation-file.md, "Table".
[[nodiscard]] std::string operation_header(const OperationLayout& layout);

}  // namespace restrip::generator
