// Strict reader for text: words separated by one space, lines that end with a newline, nothing else. Any deviation is
// an InputError that names file, line and expectation.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "common/reading.hpp"
#include "model/masks.hpp"

namespace restrip::verify {

/// The error of a line; 0 if the whole file is at fault.
class InputError : public files::FileError {
 public:
  InputError(const std::string& file, unsigned line, const std::string& what);
};

/// Lines of a text, one at a time.
class LineReader {
 public:
  LineReader(std::string file, std::string text);

  /// Moves to the next line and splits it; throws InputError, naming what was expected, at the end of the text.
  void next(const std::string& expected);
  bool at_end() const { return position_ == text_.size(); }

  const std::vector<std::string_view>& words() const { return words_; }
  bool starts_with(std::string_view word) const { return words_.front() == word; }
  /// The words from `first` to the end, with their spaces.
  std::string rest(std::size_t first) const;
  unsigned line() const { return line_; }
  /// All earlier lines, with their newlines.
  std::string_view text_above() const { return std::string_view(text_).substr(0, line_start_); }

  void expect_words(std::size_t count, const std::string& expected) const;
  void expect_line(std::string_view whole) const;
  /// Word number `index` as a decimal number without leading zeros, possibly negative.
  std::int64_t number(std::size_t index) const;
  /// Word number `index` as a lower-case hexadecimal mask of at most `bits` bits.
  Mask mask(std::size_t index, unsigned bits) const;
  /// Word number `index` as a mask of at most 127 bits, in the same notation.
  WideMask wide_mask(std::size_t index, unsigned bits) const;

  [[noreturn]] void fail(const std::string& what) const;

 private:
  std::string file_;
  std::string text_;
  std::size_t position_ = 0;
  std::size_t line_start_ = 0;
  unsigned line_ = 0;
  std::vector<std::string_view> words_;
};

/// The bytes of a file; throws files::FileError if it cannot be read.
std::string read_file(const std::string& path);

}  // namespace restrip::verify
