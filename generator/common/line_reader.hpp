// Files of lines of words, as shards, certificates and dumps are.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>

#include "operations/operation.hpp"

namespace restrip::generator {

/// Words and numbers of one line; `good` stays true as long as all was as expected.
class Words {
 public:
  explicit Words(std::string_view line) : rest_(line) {}

  std::string_view next() {
    const std::size_t end = std::min(rest_.find(' '), rest_.size());
    const std::string_view word = rest_.substr(0, end);
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    return word;
  }
  void expect(std::string_view word) { good = next() == word && good; }
  Mask number(int base, Mask end) {
    const std::string_view word = next();
    Mask value = 0;
    const auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), value, base);
    good = good && error == std::errc{} && stop == word.data() + word.size() && value < end;
    return value;
  }
  [[nodiscard]] bool at_end() const { return rest_.empty(); }

  bool good = true;

 private:
  std::string_view rest_;
};

/// A file line by line, with the place for complaints.
struct Reader {
  std::filesystem::path file;
  std::string remedy;
  std::string_view text;
  std::size_t at = 0;
  std::size_t line = 1;

  [[nodiscard]] std::string_view peek() const { return text.substr(at, text.find('\n', at) - at); }
  void skip() {
    at += peek().size() + 1;
    ++line;
  }
  [[noreturn]] void refuse(const std::string& wanted) const {
    throw std::runtime_error(
        fmt::format("{}:{}: '{}' where {} should be; {}", file.string(), line, peek(), wanted, remedy));
  }
  void expect(const std::string& wanted) {
    if (peek() != wanted) refuse("'" + wanted + "'");
    skip();
  }
  [[nodiscard]] bool starts(std::string_view word) const { return text.substr(at, word.size()) == word; }
};

}  // namespace restrip::generator
