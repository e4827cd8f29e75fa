// The message of a refusal.
#pragma once

#include <string>

#include "common/reading.hpp"

namespace restrip {

/// The message of the exception that `work` throws, or an empty text if it throws nothing. Other exceptions propagate.
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
