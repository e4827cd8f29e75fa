// The header of the table of an operation or a family of one's own: docs/operation-file.md, "Table".
#pragma once

#include <string>

#include "operations/operation_layout.hpp"

namespace restrip::generator {

/// Of its positions in ascending order, or of its only one.
[[nodiscard]] std::string operation_header(const OperationLayout& layout);

/// Where the files of an operation lie in a folder of tables.
[[nodiscard]] std::string operation_certificate_path(const std::string& name);
[[nodiscard]] std::string operation_header_path(const std::string& name);

}  // namespace restrip::generator
