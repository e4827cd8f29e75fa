#pragma once
// Is a proof right? Every clause must follow from those before it by unit propagation, every clause deleted must be
// there, and the empty clause must come. RAT, the rest of DRAT, is not accepted: the solver's default steps do not
// need it, and without it every line is a consequence of the formula, which is easier to believe.

#include <string>
#include <vector>

#include "sat/cnf.hpp"

namespace restrip::verify::sat {

struct ProofVerdict {
  bool proved = false;
  std::string fault;                            ///< with its line, when not proved
  std::vector<std::size_t> core;                ///< the proof steps on which the empty clause rests, ascending
  std::vector<std::vector<std::size_t>> hints;  ///< of each: the clauses that propagate, in this order, by LRAT number
};

ProofVerdict check_proof(const Cnf& cnf, const Proof& proof);

/// What a proof rests on, as an LRAT file. Clauses are numbered from 1, those of the formula first.
std::string lrat_of(const Cnf& cnf, const Proof& proof, const ProofVerdict& verdict);

}  // namespace restrip::verify::sat
