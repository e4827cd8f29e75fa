// A family at one position as an operation file.
#pragma once

#include <string>

#include "operations/description.hpp"

namespace restrip::generator {

/// The operation file of a family at one position, with the preference of its shipped rules; named "split-k4-a2", or
/// "flip-own". Under another constraint than that of the family the preference is the usual one, which is none in the
/// file, and the constraint's word ends the name.
[[nodiscard]] std::string operation_file_text(const Position& position, Constraint constraint = {});

}  // namespace restrip::generator
