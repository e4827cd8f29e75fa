#pragma once
// Formulas in conjunctive normal form and proofs that they have no model, and the file formats of both. DIMACS: "p cnf
// VARIABLES CLAUSES", then each clause as its literals and a 0. Variables count from 1; a negative number is a variable
// negated. DRAT, the text form that SAT solvers write: a line is a clause that follows, "d" and a clause that is no
// longer needed, or "0", the empty clause, which ends the proof.

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

struct ProofStep {
  bool deletes = false;
  Clause clause;
  unsigned line = 0;
};

using Proof = std::vector<ProofStep>;

/// InputError, naming file and line, when the text is no such proof or names a variable that the formula lacks.
Proof parse_proof(const std::string& file, const std::string& text, int variables);

}  // namespace restrip::verify::sat
