#pragma once
// Controls: alterations that must change the verdict. A formula that stays unsatisfiable whatever it claims, or a
// checker that accepts whatever it reads, proves nothing.

#include "certificate/certificate.hpp"
#include "sat/encoding.hpp"
#include "sat/proof_check.hpp"

namespace restrip::verify::sat {

struct ControlResult {
  std::size_t altered_formulas = 0;  ///< all were satisfiable when there is no fault
  std::size_t cut_proofs = 0;        ///< proofs from which one line was taken that the proof rests on
  std::size_t refused = 0;           ///< of those; a line can be dispensable though the proof used it
  std::string fault;
};

/// An assignment read back as colours.
struct Counterexample {
  Colors before;
  Colors after;
};
Counterexample read_back(const Encoding& encoding, const std::vector<bool>& model);

/// What the verifier's own survey of colours has against the claim that the recolouring is a sound one of a valid
/// configuration with the bound's key, and better than the bound; empty when it agrees.
std::string objection(const Operation& operation, const Counterexample& found, const Bound& bound);

/// The formulas that differ from the position's in one row: a bound of `row` made worse by one, or the row left out.
struct Alteration {
  std::string what;
  std::vector<Bound> bounds;
  Bound beaten;  ///< what a model must beat
};
std::vector<Alteration> alterations(const Position& position, const std::vector<Bound>& bounds, std::size_t row);

/// The altered formula with the key of the altered row put in as facts, and without the other rows, which then say
/// nothing. The unaltered formula has no model, so it makes no difference to the verdict, only to the time.
Encoding with_key_as_facts(const Position& position, const Alteration& alteration);

/// The proof without the clause of one step; where it was deleted later, that is left out as well.
Proof without_step(const Proof& proof, std::size_t step);

/// Cuts lines out of a proof that is right: without its empty clause and without all other clauses it must be refused;
/// lines of its core, evenly spaced, are counted.
void cut_proof(const Cnf& cnf, const Proof& proof, const ProofVerdict& verdict, ControlResult& result);

}  // namespace restrip::verify::sat
