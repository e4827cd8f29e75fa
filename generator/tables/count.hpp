// The counts of docs/explanation/theory.md section 6, computed, next to the paper's figures.
#pragma once

#include <string>

namespace restrip::generator {

struct CountReport {
  std::string text;  ///< a table, and a line that explains each count
  std::string json;  ///< one object
};
[[nodiscard]] CountReport count(unsigned max_k);

}  // namespace restrip::generator
