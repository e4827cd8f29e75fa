#pragma once
// The header of an operation's table, as docs/operation-file.md, "Table", has it. A program that is compiled from it
// can do whatever its text says, so the text is read before such a program is run.

#include <cstdint>
#include <string>
#include <string_view>

#include "operation_file.hpp"
#include "report.hpp"

namespace restrip::verify::operations {

struct HeaderCheck {
  std::uint64_t lines = 0;
  Failures wrong;  ///< lines that a table of this operation does not have
};

/// Every line must be the one that the page says, but for the table's numbers: as many as the operation has
/// configurations, decimal, without leading zeros, none beyond the type of the entries.
HeaderCheck check_operation_header(const std::string& file, std::string_view text, const OperationFile& operation);

}  // namespace restrip::verify::operations
