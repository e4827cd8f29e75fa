// Text of the files made from an operation file: docs/operation-file.md, "Certificate" and "Table".
#pragma once

#include <string>

#include "operations/solve.hpp"

namespace restrip::generator {

/// Shows progress on a terminal, since reasons take time.
[[nodiscard]] std::string operation_certificate(const NamedOperation& named, const OperationRules& rules);

/// A header and the read-only data that it compiles to.
struct OperationHeader {
  std::string text;
  std::size_t bytes = 0;
};
[[nodiscard]] OperationHeader operation_header(const NamedOperation& named, const OperationRules& rules);

/// Where the two lie in a folder of tables.
[[nodiscard]] std::string operation_certificate_path(const std::string& name);
[[nodiscard]] std::string operation_header_path(const std::string& name);

}  // namespace restrip::generator
