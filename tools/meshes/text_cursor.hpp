// Walks through a text by lines and words, and knows the line number for messages. Never reads past the end, whatever
// the bytes are.
#pragma once

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

/// The number that a whole word spells; a leading + is allowed. None where it is beyond the range of a double, at
/// either end.
template <class Number>
[[nodiscard]] std::optional<Number> parse(std::string_view word) {
  if (!word.empty() && word.front() == '+') word.remove_prefix(1);
  Number number{};
#ifndef __cpp_lib_to_chars  // a library whose from_chars knows whole numbers only, as libc++ 14
  if constexpr (std::is_floating_point_v<Number>) {
    const std::string text(word);
    if (text.empty() || text.front() == '+' || text.find_first_of("xX") != std::string::npos) return std::nullopt;
    char* stop = nullptr;
    errno = 0;
    number = std::strtod(text.c_str(), &stop);
    const bool beyond = errno == ERANGE && (number == 0 || std::isinf(number));
    if (stop != text.c_str() + text.size() || beyond) return std::nullopt;
    return number;
  } else
#endif
  {
    const auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), number);
    if (error != std::errc{} || stop != word.data() + word.size()) return std::nullopt;
    return number;
  }
}

class TextCursor {
 public:
  explicit TextCursor(std::string_view text) : rest_(text) {}

  [[nodiscard]] bool at_end() const noexcept { return rest_.empty(); }
  [[nodiscard]] std::size_t line() const noexcept { return line_; }
  /// What has not been read, from the current place on.
  [[nodiscard]] std::string_view rest() const noexcept { return rest_; }

  /// The next word of this line; empty at its end. A # begins a comment that lasts to the end of the line. A backslash
  /// at the end of a line continues it.
  std::string_view word() {
    skip_blanks();
    std::size_t size = 0;
    while (size < rest_.size() && !is_blank(rest_[size]) && rest_[size] != '\n') ++size;
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

  /// Leaves the rest of this line unread.
  void next_line() {
    const std::size_t stop = rest_.find('\n');
    rest_.remove_prefix(stop == std::string_view::npos ? rest_.size() : stop + 1);
    ++line_;
  }

 private:
  static bool is_blank(char c) noexcept { return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f'; }

  void skip_blanks() {
    while (!rest_.empty()) {
      if (is_blank(rest_.front())) {
        rest_.remove_prefix(1);
      } else if (rest_.front() == '#') {
        const std::size_t stop = rest_.find('\n');
        rest_.remove_prefix(stop == std::string_view::npos ? rest_.size() : stop);
      } else if (rest_.starts_with("\\\n") || rest_.starts_with("\\\r\n")) {
        rest_.remove_prefix(rest_.find('\n') + 1);
        ++line_;
      } else {
        return;
      }
    }
  }

  std::string_view rest_;
  std::size_t line_ = 1;
};

}  // namespace restrip::tools
