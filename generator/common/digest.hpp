// Digests of files.
#pragma once

#include <string>

namespace restrip::generator {

/// SHA-256 in lower-case hexadecimal.
[[nodiscard]] std::string sha256(const std::string& bytes);

}  // namespace restrip::generator
