#pragma once
// The rows of an automaton's certificate (docs/certificate.md), read one section after the other and counted.

#include <cstddef>
#include <cstdint>
#include <string>

#include "model/input.hpp"

namespace restrip::verify {

class RowReader {
 public:
  explicit RowReader(LineReader& reader) : lines_(reader) {}

  /// The head of a section, and the first line behind it, which starts with `first_row`.
  void begin_section(const std::string& name, const char* first_row);
  /// Throws InputError unless the section had as many rows as its head claims.
  void end_section() const;
  /// Counts the row that was read and goes on to the next line.
  void next();
  /// Rows so far, of all sections.
  std::size_t rows() const { return rows_; }

  /// A number from `least` to `most`; `what` is its name in the error.
  std::int64_t number_at(std::size_t word, std::int64_t least, std::int64_t most, const char* what = "a number") const;
  void expect_number(std::size_t word, std::size_t n) const;
  void expect_letter(std::size_t word, char letter) const;
  /// The number of the case that two letters name.
  std::size_t case_at(std::size_t word) const;

 private:
  LineReader& lines_;
  std::string section_;
  std::size_t rows_ = 0;
  std::size_t section_start_ = 0;
  std::size_t claimed_ = 0;
};

}  // namespace restrip::verify
