// The families of docs/notation.md as operation files.
#pragma once

#include <string>

#include "operations/operation_file.hpp"

namespace restrip::generator {

/// The operation of a family at one position, with the preference of its shipped rules; named "split-k4-a2". Under
/// another constraint than that of strips the preference is the usual one, which is none in the file, and the
/// constraint's word ends the name.
[[nodiscard]] NamedOperation described(const Position& position, Constraint constraint = {});

/// The operation as an operation file.
[[nodiscard]] std::string operation_file_text(const NamedOperation& named);

}  // namespace restrip::generator
