#include "model/input.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>

#include "common/reading.hpp"

namespace restrip::verify {
namespace {

// Limits in bytes, so that endless input is refused. The longest line of the shipped tables has a few hundred.
constexpr std::size_t largest_file = std::size_t{1} << 28U;
constexpr std::size_t longest_line = std::size_t{1} << 16U;

}  // namespace

InputError::InputError(const std::string& file, unsigned line, const std::string& what)
    : files::FileError(line == 0 ? fmt::format("{}: {}", file, what) : fmt::format("{}:{}: {}", file, line, what)) {}

LineReader::LineReader(std::string file, std::string text) : file_(std::move(file)), text_(std::move(text)) {}

void LineReader::fail(const std::string& what) const { throw InputError(file_, line_, what); }

void LineReader::next(const std::string& expected) {
  ++line_;
  if (at_end()) fail(fmt::format("expected {}, found the end of the file", expected));
  const std::size_t end = text_.find('\n', position_);
  if (std::min(end, text_.size()) - position_ > longest_line)
    fail(fmt::format("expected {}, found a line of more than {} bytes, the limit", expected, longest_line));
  if (end == std::string::npos) fail(fmt::format("expected {} and a newline, found an unfinished line", expected));
  const std::string_view whole = std::string_view(text_).substr(position_, end - position_);
  line_start_ = position_;
  position_ = end + 1;
  for (const char c : whole)
    if (c < ' ' || c > '~') fail("expected printable ASCII");
  words_.clear();
  for (std::size_t start = 0; start <= whole.size();) {
    const std::size_t space = std::min(whole.find(' ', start), whole.size());
    words_.push_back(whole.substr(start, space - start));
    if (words_.back().empty())
      fail(fmt::format("expected {}, words separated by one space; found an empty word", expected));
    start = space + 1;
  }
}

std::string LineReader::rest(std::size_t first) const {
  return fmt::format(
      "{}", fmt::join(words_.begin() + static_cast<std::ptrdiff_t>(std::min(first, words_.size())), words_.end(), " "));
}

void LineReader::expect_words(std::size_t count, const std::string& expected) const {
  if (words_.size() != count) fail(fmt::format("expected {}, found \"{}\"", expected, rest(0)));
}

void LineReader::expect_line(std::string_view whole) const {
  if (rest(0) != whole) fail(fmt::format("expected \"{}\", found \"{}\"", whole, rest(0)));
}

std::int64_t LineReader::number(std::size_t index) const {
  const std::string_view word = words_[index];
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size() || std::to_string(value) != word)
    fail(fmt::format("expected a decimal number without leading zeros, found \"{}\"", word));
  return value;
}

WideMask LineReader::wide_mask(std::size_t index, unsigned bits) const {
  const std::string_view word = words_[index];
  WideMask value = 0;
  for (const char c : word.substr(0, 32)) value = value << 4U | (std::string_view("0123456789abcdef").find(c) & 15U);
  if (fmt::format("{:x}", value) != word)
    fail(fmt::format("expected a lower-case hexadecimal mask without leading zeros, found \"{}\"", word));
  if (value >> bits != 0) fail(fmt::format("expected a mask of at most {} bits, found \"{}\"", bits, word));
  return value;
}

Mask LineReader::mask(std::size_t index, unsigned bits) const { return static_cast<Mask>(wide_mask(index, bits)); }

std::string read_file(const std::string& path) { return files::read_whole(path, {largest_file, largest_file}); }

}  // namespace restrip::verify
