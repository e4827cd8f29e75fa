// The lines of a dump, which is too long to be kept in memory.
#pragma once

#include <fmt/format.h>
#include <sys/wait.h>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "model/input.hpp"

namespace restrip::verify {

/// A line that does not belong in a dump.
class BadDump : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Lines of a stream. There are millions, so lines are not allocated individually. Any deviation is a BadDump.
class StreamLines {
 public:
  explicit StreamLines(std::FILE* stream) : stream_(stream), buffer_(1U << 18U) {}

  /// The next line without its newline; nullopt at the end. A last line without a newline is ignored.
  std::optional<std::string_view> next() {
    while (true) {
      const std::string_view waiting(buffer_.data() + start_, end_ - start_);
      if (const std::size_t newline = waiting.find('\n'); newline != std::string_view::npos) {
        start_ += newline + 1;
        ++number_;
        return waiting.substr(0, newline);
      }
      if (!refill()) return {};
    }
  }
  std::uint64_t number() const { return number_; }

  [[noreturn]] void fail(const std::string& what) const {
    throw BadDump(fmt::format("line {}{}: {}", number_, place, what));
  }
  /// The next line, which must exist; `expected` describes it.
  std::string_view next(const std::string& expected) {
    const std::optional<std::string_view> line = next();
    if (!line) fail(fmt::format("expected \"{}\", found the end", expected));
    return *line;
  }
  void expect(const std::string& whole) {
    if (const std::string_view line = next(whole); line != whole)
      fail(fmt::format("expected \"{}\", found \"{}\"", whole, line));
  }
  /// Reads the last line and checks that nothing follows.
  void expect_last(const std::string& whole) {
    expect(whole);
    if (next() || start_ != end_) fail("text after the end");
  }
  /// A whole word of the line as a number.
  std::uint64_t number_in(std::string_view digits, int base) const {
    std::uint64_t number = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number, base);
    if (error != std::errc{} || end != digits.data() + digits.size())
      fail(fmt::format("expected a number, found \"{}\"", digits));
    return number;
  }

  std::string place;  ///< position in the dump, for messages: ", table flip"

 private:
  bool refill() {
    std::copy(buffer_.begin() + static_cast<std::ptrdiff_t>(start_),
              buffer_.begin() + static_cast<std::ptrdiff_t>(end_), buffer_.begin());
    end_ -= start_;
    start_ = 0;
    if (end_ == buffer_.size())
      throw BadDump(fmt::format("line {}: longer than {} bytes, the limit", number_ + 1, buffer_.size()));
    const std::size_t count = std::fread(buffer_.data() + end_, 1, buffer_.size() - end_, stream_);
    end_ += count;
    return count != 0;
  }

  std::FILE* stream_;
  std::vector<char> buffer_;
  std::size_t start_ = 0;
  std::size_t end_ = 0;
  std::uint64_t number_ = 0;
};

/// Runs `read` on a dump as far as it can be read; the reason why it stopped is stored in `fault`.
template <class Found, class Read>
Found found_in(std::FILE* stream, const Read& read) {
  Found found;
  StreamLines lines(stream);
  try {
    read(lines, found);
  } catch (const BadDump& bad) {
    found.fault = bad.what();
  }
  return found;
}

/// Runs a program and lets `read` check its output. A failing program is a fault of the result; a program that cannot
/// be run is an InputError.
template <class Read>
auto checked_output_of(const std::string& program, const Read& read) {
  decltype(read(static_cast<std::FILE*>(nullptr))) found{};
  std::FILE* const stream = popen(program.c_str(), "r");
  if (stream == nullptr) throw InputError(program, 0, "cannot be run");
  found = read(stream);
  const int status = pclose(stream);
  if (const int code = WIFEXITED(status) ? WEXITSTATUS(status) : 0;
      code == 126 || code == 127)  // the exit codes of shells
    throw InputError(program, 0, "cannot be run");
  if (found.fault.empty() && status != 0) found.fault = program + " failed";
  return found;
}

}  // namespace restrip::verify
