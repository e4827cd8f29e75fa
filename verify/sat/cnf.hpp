#pragma once
// Formulas in conjunctive normal form, and their file format (DIMACS): "p cnf VARIABLES CLAUSES", then each clause as
// its literals and a 0. Variables count from 1; a negative number is a variable negated.

#include <string>
#include <vector>

namespace restrip::verify::sat {

using Literal = int;
using Clause = std::vector<Literal>;

struct Cnf {
  int variables = 0;
  std::vector<Clause> clauses;
};

/// The formula as a DIMACS file; the comment, one line, goes on top.
std::string dimacs_of(const Cnf& cnf, const std::string& comment);

/// InputError (naming file and line) when the text is no DIMACS formula: a clause over the edge of its line, a literal
/// without a variable, more or fewer clauses than announced.
Cnf parse_dimacs(const std::string& file, const std::string& text);

}  // namespace restrip::verify::sat
