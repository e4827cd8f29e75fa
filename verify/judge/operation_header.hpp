#pragma once
// The header of an operation's table, as docs/operation-file.md, "Table", has it. A program that is compiled from it
// can do whatever its text says, so the text is read before such a program is run.

#include <cstdint>
#include <string>
#include <string_view>

#include "judge/report.hpp"
#include "model/description.hpp"

namespace restrip::verify {

struct HeaderCheck {
  std::uint64_t lines = 0;
  Failures wrong;  ///< lines that a table of this operation does not have
};

/// Every line must be the one that the page says, but for the numbers of the table and of the triangles: as many as the
/// operation has configurations and triangles, decimal, without leading zeros, within their types and what they number.
/// The table of a family has all positions whose first number is at most `max_k`.
HeaderCheck check_operation_header(const std::string& file, std::string_view text, const Description& description,
                                   unsigned max_k);

}  // namespace restrip::verify
