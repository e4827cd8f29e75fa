// The families of docs/notation.md as operation files.
#pragma once

#include <string>

#include "operations/operation_file.hpp"

namespace restrip::generator {

/// The operation of a family at one position, with the preference of its shipped rules; named "split-k4-a2".
[[nodiscard]] NamedOperation described(const Position& position);

/// The operation as an operation file.
[[nodiscard]] std::string operation_file_text(const NamedOperation& named);

}  // namespace restrip::generator
