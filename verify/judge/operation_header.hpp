// Checks the header of an operation's table against docs/reference/operation-file.md, "Table". A program compiled from
// it executes whatever it says, so the text is checked before such a program is run.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "judge/report.hpp"
#include "judge/table_dump.hpp"
#include "model/description.hpp"

namespace restrip::verify {

struct HeaderCheck {
  std::uint64_t lines = 0;
  Failures wrong;  ///< lines that a table of this operation does not have
  /// The numbers of the table if nothing is wrong, position by position in ascending order.
  std::vector<std::uint32_t> entries;
  unsigned width = 0;  ///< bits of an entry
};

/// Every line must be as the page says, except the entries of the table: one per configuration, decimal, without
/// leading zeros, each a rule or all ones. The triangles must equal the description in traversal order from the first.
/// The table of a family has all positions whose first number is at most `max_k`.
HeaderCheck check_operation_header(const std::string& file, std::string_view text, const Description& description,
                                   unsigned max_k);

/// Compares the entries of a header with `expected`, the tables of the same positions.
DumpComparison compare_header(const HeaderCheck& header, const ExpectedDump& expected);

}  // namespace restrip::verify
