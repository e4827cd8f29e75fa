// Numbers in lines of at most 120 characters, as generated headers write them.
#pragma once

#include <fmt/format.h>

#include <string>
#include <vector>

namespace restrip::generator {

/// Words in lines of at most 120 characters.
class Lines {
 public:
  void add(const std::string& word) {
    if (line_.size() + word.size() > 120) {
      text_ += line_ + "\n";
      line_ = "   ";
    }
    line_ += word;
  }
  [[nodiscard]] std::string text() const { return text_ + line_ + "\n"; }

 private:
  std::string text_;
  std::string line_ = "   ";
};

template <class Number>
std::string numbers(const std::vector<Number>& values, const char* spelling = " {},") {
  Lines lines;
  for (const Number& value : values) lines.add(fmt::format(fmt::runtime(spelling), value));
  return lines.text();
}

}  // namespace restrip::generator
