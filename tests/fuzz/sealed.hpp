// Shared by the targets of certificates.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "model/input.hpp"

namespace restrip::fuzz {

/// Replaces the sums in the last line by matching ones, so that alterations reach the reader.
std::string sealed(std::string_view text);

std::vector<std::string> lines_of(std::string_view text);

/// False if the reader throws files::FileError.
template <class Read>
std::function<bool(std::string_view)> refusing(Read&& read) {
  return [read](std::string_view bytes) {
    try {
      return read(bytes);
    } catch (const files::FileError&) {
      return false;
    }
  };
}

}  // namespace restrip::fuzz
