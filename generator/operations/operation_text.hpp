// The header of the table of an operation or a family of one's own: docs/operation-file.md, "Table".
#pragma once

#include <string>
#include <vector>

#include "solve/section.hpp"

namespace restrip::generator {

/// A header, and how many bytes its table of rules has.
struct OperationHeader {
  std::string text;
  std::size_t bytes = 0;
};

/// A position and the solved section whose rows answer its configurations.
struct AnsweredPosition {
  Position position;
  const Section* section = nullptr;
};

/// The header of a description: of its positions in ascending order, or of its only one.
[[nodiscard]] OperationHeader operation_header(const std::vector<AnsweredPosition>& positions);

/// Where the files of an operation lie in a folder of tables.
[[nodiscard]] std::string operation_certificate_path(const std::string& name);
[[nodiscard]] std::string operation_header_path(const std::string& name);

}  // namespace restrip::generator
