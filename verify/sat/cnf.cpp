#include "sat/cnf.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cstdint>
#include <cstdlib>
#include <iterator>
#include <string_view>

#include "model/input.hpp"

namespace restrip::verify::sat {
namespace {

constexpr std::string_view header = "p cnf ";

/// Lines of numbers that end with 0: what both formats are made of.
class NumberReader {
 public:
  NumberReader(std::string file, std::string_view text) : file_(std::move(file)), text_(text) {}

  bool at_end() const { return position_ == text_.size(); }
  unsigned line() const { return line_; }

  /// Goes on to the next line, which must end with a newline: a file that was cut off is noticed.
  std::string_view next_line();
  /// The numbers of `words`, all but the closing 0; InputError unless each is a literal of 1 … `variables`.
  Clause clause(std::string_view words, int variables) const;
  [[noreturn]] void fail(const std::string& what) const { throw InputError(file_, line_, what); }

 private:
  std::string file_;
  std::string_view text_;
  std::size_t position_ = 0;
  unsigned line_ = 0;
};

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

Cnf sizes_of(const NumberReader& reader, std::string_view line, std::size_t& clauses) {
  Cnf cnf;
  const char* const end = line.data() + line.size();
  const auto variables = std::from_chars(line.data() + header.size(), end, cnf.variables);
  const bool goes_on = variables.ec == std::errc() && variables.ptr != end && *variables.ptr == ' ';
  if (!goes_on || cnf.variables < 0) reader.fail("expected \"p cnf VARIABLES CLAUSES\"");
  const auto count = std::from_chars(variables.ptr + 1, end, clauses);
  if (count.ec != std::errc() || count.ptr != end) reader.fail("expected \"p cnf VARIABLES CLAUSES\"");
  return cnf;
}

}  // namespace

std::string dimacs_of(const Cnf& cnf, const std::string& comment) {
  fmt::memory_buffer text;
  fmt::format_to(std::back_inserter(text), "c {}\np cnf {} {}\n", comment, cnf.variables, cnf.clauses.size());
  for (const Clause& clause : cnf.clauses) {
    for (const Literal literal : clause) fmt::format_to(std::back_inserter(text), "{} ", literal);
    fmt::format_to(std::back_inserter(text), "0\n");
  }
  return fmt::to_string(text);
}

Cnf parse_dimacs(const std::string& file, const std::string& text) {
  NumberReader reader(file, text);
  std::string_view line = reader.next_line();
  while (line.starts_with("c")) line = reader.next_line();
  if (!line.starts_with(header)) reader.fail("expected \"p cnf VARIABLES CLAUSES\"");
  std::size_t announced = 0;
  Cnf cnf = sizes_of(reader, line, announced);
  while (!reader.at_end()) {
    line = reader.next_line();
    if (!line.starts_with("c")) cnf.clauses.push_back(reader.clause(line, cnf.variables));
  }
  if (cnf.clauses.size() != announced)
    reader.fail(fmt::format("{} clauses announced, {} found", announced, cnf.clauses.size()));
  return cnf;
}

Proof parse_proof(const std::string& file, const std::string& text, int variables) {
  NumberReader reader(file, text);
  Proof proof;
  while (!reader.at_end()) {
    std::string_view line = reader.next_line();
    const bool deletes = line.starts_with("d ");
    if (deletes) line.remove_prefix(2);
    proof.push_back({deletes, reader.clause(line, variables), reader.line()});
  }
  return proof;
}

}  // namespace restrip::verify::sat
