// Walks through a text by lines and words, and knows the line number for messages. Skips a byte order mark; lines end
// with LF, CRLF or CR. Never reads past the end, whatever the bytes are.
#pragma once

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>

namespace restrip::tools {

/// The number that a whole word spells; a leading + is allowed. A number too small for a double is 0 or the nearest
/// that there is; empty for one that is too large.
template <class Number>
[[nodiscard]] std::optional<Number> parse(std::string_view word) {
  if (!word.empty() && word.front() == '+') word.remove_prefix(1);
  Number number{};
#ifndef __cpp_lib_to_chars  // a library whose from_chars supports integers only, as libc++ 14
  if constexpr (std::is_floating_point_v<Number>) {
    const std::string text(word);
    if (text.empty() || text.front() == '+' || text.find_first_of("xX") != std::string::npos) return std::nullopt;
    char* stop = nullptr;
    errno = 0;
    number = std::strtod(text.c_str(), &stop);
    const bool beyond = errno == ERANGE && std::isinf(number);
    if (stop != text.c_str() + text.size() || beyond) return std::nullopt;
    return number;
  } else
#endif
  {
    const auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), number);
    if (stop != word.data() + word.size() || error == std::errc::invalid_argument) return std::nullopt;
    if (error == std::errc{}) return number;
    if constexpr (std::is_floating_point_v<Number>) {  // from_chars does not say which end of the range was exceeded
      const std::string text(word);
      number = std::strtod(text.c_str(), nullptr);
      if (std::abs(number) <= 1) return number;
    }
    return std::nullopt;
  }
}

class TextCursor {
 public:
  explicit TextCursor(std::string_view text) : rest_(text) {
    if (rest_.starts_with("\xEF\xBB\xBF")) rest_.remove_prefix(3);
  }

  [[nodiscard]] bool at_end() const noexcept { return rest_.empty(); }
  [[nodiscard]] std::size_t line() const noexcept { return line_; }
  /// The unread text from the current position.
  [[nodiscard]] std::string_view rest() const noexcept { return rest_; }

  /// The next word of this line; empty at its end. A # begins a comment that lasts to the end of the line. A backslash
  /// at the end of a line ends the word and continues the line.
  std::string_view word() {
    while (!rest_.empty()) {
      if (is_blank(rest_.front())) {
        rest_.remove_prefix(1);
      } else if (rest_.front() == '#') {
        rest_.remove_prefix(std::min(rest_.find_first_of(line_ends), rest_.size()));
      } else if (continues(0)) {
        rest_.remove_prefix(1);
        skip_line_end();
      } else {
        break;
      }
    }
    std::size_t size = 0;
    while (size < rest_.size() && !is_blank(rest_[size]) && !ends_line(rest_[size]) && !continues(size)) ++size;
    const std::string_view found = rest_.substr(0, size);
    rest_.remove_prefix(size);
    return found;
  }

  /// The next word, on this line or a later one; empty at the end of the text.
  std::string_view word_on_any_line() {
    while (true) {
      const std::string_view found = word();
      if (!found.empty() || at_end()) return found;
      next_line();
    }
  }

  /// Skips the rest of this line.
  void next_line() {
    rest_.remove_prefix(std::min(rest_.find_first_of(line_ends), rest_.size()));
    skip_line_end();
  }

 private:
  static constexpr std::string_view line_ends = "\n\r";
  static bool is_blank(char c) noexcept { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }
  static bool ends_line(char c) noexcept { return c == '\n' || c == '\r'; }
  /// Whether a backslash stands there as the last character of its line.
  [[nodiscard]] bool continues(std::size_t at) const noexcept {
    return rest_[at] == '\\' && (at + 1 == rest_.size() || ends_line(rest_[at + 1]));
  }

  void skip_line_end() {
    rest_.remove_prefix(rest_.starts_with("\r\n") ? 2 : std::min<std::size_t>(rest_.size(), 1));
    ++line_;
  }

  std::string_view rest_;
  std::size_t line_ = 1;
};

}  // namespace restrip::tools
