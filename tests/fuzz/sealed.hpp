// What the targets of certificates have in common.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "model/input.hpp"

namespace restrip::fuzz {

/// With the sums in its last line that the lines above ask for, so that alterations reach the reader.
std::string sealed(std::string_view text);

std::vector<std::string> lines_of(std::string_view text);

/// False where the reader throws InputError.
template <class Read>
std::function<bool(std::string_view)> refusing(Read&& read) {
  return [read](std::string_view bytes) {
    try {
      return read(bytes);
    } catch (const verify::InputError&) {
      return false;
    }
  };
}

}  // namespace restrip::fuzz
