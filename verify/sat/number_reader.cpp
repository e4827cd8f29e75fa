#include "sat/number_reader.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cstdint>
#include <cstdlib>

#include "model/input.hpp"

namespace restrip::verify::sat {

std::string_view NumberReader::next_line() {
  ++line_;
  const std::size_t end = text_.find('\n', position_);
  if (end == std::string_view::npos) fail("the file ends in the middle of a line; was it cut off?");
  const std::string_view line = text_.substr(position_, end - position_);
  position_ = end + 1;
  return line;
}

Clause NumberReader::clause(std::string_view words, int variables) const {
  Clause clause;
  const char* at = words.data();
  const char* const end = at + words.size();
  while (true) {
    while (at != end && *at == ' ') ++at;
    int number = 0;
    const auto [rest, error] = std::from_chars(at, end, number);
    if (error != std::errc() || (rest != end && *rest != ' '))
      fail(fmt::format("expected numbers and a closing 0, found \"{}\"", words));
    at = rest;
    if (number == 0) break;
    if (number > variables || number < -variables)
      fail(fmt::format("there is no variable {}; the formula has {}", std::abs(std::int64_t{number}), variables));
    clause.push_back(number);
  }
  if (at != end) fail(fmt::format("expected the end of the line after the 0, found \"{}\"", words));
  return clause;
}

void NumberReader::fail(const std::string& what) const { throw InputError(file_, line_, what); }

}  // namespace restrip::verify::sat
