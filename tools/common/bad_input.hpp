// What the program says when it cannot use what it was given: exit code 2, and one sentence with the file and the
// remedy.
#pragma once

#include <stdexcept>

namespace restrip::tools {

/// The input is at fault, not the program. The text names the file, the place where that helps, and what to do.
class BadInput : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace restrip::tools
