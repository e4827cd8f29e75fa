#pragma once
// What a refusal says.

#include <string>

#include "common/file_error.hpp"

namespace restrip {

/// The message of the exception that ends `work`; empty if it comes to its end. Other exceptions propagate.
template <class Error = files::FileError, class Work>
std::string refusal_of(Work&& work) {
  try {
    work();
  } catch (const Error& error) {
    return error.what();
  }
  return {};
}

}  // namespace restrip
