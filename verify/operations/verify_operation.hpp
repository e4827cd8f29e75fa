#pragma once
// The whole verification of one operation of a user's own, from its file and docs/operation-file.md alone.

#include <string>

#include "report.hpp"

namespace restrip::verify::operations {

struct OperationOptions {
  std::string operation;     ///< the file that describes it
  std::string certificate;   ///< the file with its rules; empty: none is checked
  std::string header;        ///< the table as the generator wrote it; empty: it is not read
  std::string dump_command;  ///< prints the compiled table; empty: it is not checked
};

/// Checks everything and hands each claim to the listener. InputError when the operation or the certificate is not well
/// formed. Memory grows with 2 to the number of inner edges and ports of a side, time with the number of worlds as
/// well: docs/operation-file.md has figures.
Totals verify_operation(const OperationOptions& options, const ClaimListener& listener);

/// "verified: split-face: 20 rules, …", or "NOT verified: …".
std::string last_line_of(const OperationOptions& options, const Totals& totals);

}  // namespace restrip::verify::operations
