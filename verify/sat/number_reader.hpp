#pragma once
// Lines of numbers that end with 0: what DIMACS formulas and DRAT proofs are made of.

#include <string>
#include <string_view>

#include "sat/cnf.hpp"

namespace restrip::verify::sat {

class NumberReader {
 public:
  NumberReader(std::string file, std::string_view text) : file_(std::move(file)), text_(text) {}

  bool at_end() const { return position_ == text_.size(); }
  unsigned line() const { return line_; }

  /// Goes on to the next line, which must end with a newline: a file that was cut off is noticed.
  std::string_view next_line();
  /// The numbers of `words`, all but the closing 0; InputError unless each is a literal of 1 … `variables`.
  Clause clause(std::string_view words, int variables) const;
  [[noreturn]] void fail(const std::string& what) const;

 private:
  std::string file_;
  std::string_view text_;
  std::size_t position_ = 0;
  unsigned line_ = 0;
};

}  // namespace restrip::verify::sat
