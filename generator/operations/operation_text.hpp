// The header of an operation's own table: docs/operation-file.md, "Table".
#pragma once

#include <string>

#include "solve/section.hpp"

namespace restrip::generator {

/// A header, and how many bytes its table of rules has.
struct OperationHeader {
  std::string text;
  std::size_t bytes = 0;
};
/// Of a solved section that serves one position.
[[nodiscard]] OperationHeader operation_header(const Section& section);

/// Where the files of an operation lie in a folder of tables.
[[nodiscard]] std::string operation_certificate_path(const std::string& name);
[[nodiscard]] std::string operation_header_path(const std::string& name);

}  // namespace restrip::generator
