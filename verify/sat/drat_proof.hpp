#pragma once
// Proofs as SAT solvers write them (DRAT, the text form): a line is a clause that follows, "d" and a clause that is no
// longer needed, or "0", the empty clause, which ends the proof.

#include "sat/cnf.hpp"

namespace restrip::verify::sat {

struct ProofStep {
  bool deletes = false;
  Clause clause;
  unsigned line = 0;
};

using Proof = std::vector<ProofStep>;

/// InputError, naming file and line, when the text is no such proof or names a variable that the formula lacks.
Proof parse_proof(const std::string& file, const std::string& text, int variables);

}  // namespace restrip::verify::sat
