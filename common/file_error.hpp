// The exception for files that cannot be used.
#pragma once

#include <stdexcept>

namespace restrip::files {

/// One line that names the file, what is wrong with it, and the remedy.
class FileError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace restrip::files
