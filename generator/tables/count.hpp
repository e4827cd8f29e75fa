// The counts of docs/explanation/theory.md section 5, computed, beside the paper's own figures.
#pragma once

#include <string>

namespace restrip::generator {

struct CountReport {
  std::string text;  ///< a table with a line on what each count means
  std::string json;  ///< one object
};
[[nodiscard]] CountReport count(unsigned max_k);

}  // namespace restrip::generator
