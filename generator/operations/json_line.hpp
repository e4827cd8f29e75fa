// Where in a JSON text a value stands, so that a complaint about it can name the line.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace restrip::generator {

/// A member by its name, or an element by its index.
struct JsonStep {
  std::string member;
  std::size_t element = 0;
};

/// The line, from 1, on which the value at the end of this path begins, or of the last value on the way that is there.
/// The text must be valid JSON.
[[nodiscard]] std::size_t line_of(std::string_view text, const std::vector<JsonStep>& path);

}  // namespace restrip::generator
