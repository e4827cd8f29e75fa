// Numbers in lines of at most 120 characters, as generated headers write them.
#pragma once

#include <fmt/format.h>

#include <string>
#include <vector>

namespace restrip::generator {

template <class Number>
std::string numbers(const std::vector<Number>& values, const char* spelling = " {},") {
  std::string text;
  std::string line = "   ";
  for (const Number& value : values) {
    const std::string word = fmt::format(fmt::runtime(spelling), value);
    if (line.size() + word.size() > 120) {
      text += line + "\n";
      line = "   ";
    }
    line += word;
  }
  return text + line + "\n";
}

}  // namespace restrip::generator
