// The counts of docs/theory.md section 5, computed, beside the paper's own figures.
#pragma once

#include <string>

namespace restrip::generator {

/// A table in plain text with a line on what each count means.
[[nodiscard]] std::string count_report(unsigned max_k);

/// The counts as one JSON object.
[[nodiscard]] std::string count_json(unsigned max_k);

}  // namespace restrip::generator
