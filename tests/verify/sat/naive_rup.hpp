#pragma once
// Proof checking as plainly as it can be written: every clause is looked at again and again until nothing moves.

#include "sat/cnf.hpp"

namespace restrip::verify::sat::test {

/// What unit propagation makes of an assignment: value[variable] is 1, -1, or 0 for open; `conflict` when some
/// clause is false altogether.
struct Propagation {
  bool conflict = false;
  std::vector<int> value;
};
Propagation propagate(const std::vector<Clause>& clauses, int variables, const std::vector<Literal>& facts);

/// Whether the proof is right, RUP and deletions.
bool naively_proved(const Cnf& cnf, const Proof& proof);

}  // namespace restrip::verify::sat::test
