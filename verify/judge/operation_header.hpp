#pragma once
// The header of an operation's table, as docs/reference/operation-file.md, "Table", has it. A program that is compiled
// from it can do whatever its text says, so the text is read before such a program is run.

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
  /// The numbers of the table, when nothing is wrong: those of one position after another, in ascending order.
  std::vector<std::uint32_t> entries;
  unsigned width = 0;  ///< bits of an entry
};

/// Every line must be the one that the page says, but for the entries of the table: as many as the operation has
/// configurations, decimal, without leading zeros, each a rule or all ones. The triangles must be those of the
/// description, as one meets them from the first. The table of a family has all positions whose first number is at most
/// `max_k`.
HeaderCheck check_operation_header(const std::string& file, std::string_view text, const Description& description,
                                   unsigned max_k);

/// Holds what the entries of a header say against `expected`, which has the tables of the same positions.
DumpComparison compare_header(const HeaderCheck& header, const ExpectedDump& expected);

}  // namespace restrip::verify
