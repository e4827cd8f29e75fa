// A promise of the library that a test without GoogleTest relies on.
#pragma once

#include <stdexcept>
#include <string>

namespace restrip::testing_support {

/// Throws std::logic_error if the promise is broken.
inline void promise(bool kept, const char* what) {
  if (!kept) throw std::logic_error(std::string("a promise was broken: ") + what);
}

}  // namespace restrip::testing_support
