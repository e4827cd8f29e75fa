// Certificates of version 2 of families and of version 1 of operations.
#pragma once

#include <string>

#include "solve/section.hpp"

namespace restrip::generator {

[[nodiscard]] std::string old_section_text(const Section& section);
[[nodiscard]] std::string old_operation_certificate(const Section& section);

}  // namespace restrip::generator
