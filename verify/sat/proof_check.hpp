#pragma once
// Is a proof right? Every clause must follow from those before it by unit propagation, every clause deleted must be
// there, and the empty clause must come. RAT, the rest of DRAT, is not accepted: the solver's default steps do not
// need it, and without it every line is a consequence of the formula, which is easier to believe.

#include "sat/drat_proof.hpp"

namespace restrip::verify::sat {

struct ProofVerdict {
  bool proved = false;
  std::string fault;              ///< with its line, when not proved
  std::vector<std::size_t> core;  ///< the proof steps on which the empty clause rests, ascending
};

ProofVerdict check_proof(const Cnf& cnf, const Proof& proof);

}  // namespace restrip::verify::sat
