#pragma once
// A circuit written down as clauses (Tseitin, 1968): every gate is a variable that clauses fix in both directions, so
// the inputs alone decide all others, and a satisfying assignment is neither more nor less than a choice of inputs.

#include "sat/cnf.hpp"

namespace restrip::verify::sat {

class Circuit {
 public:
  Circuit();

  /// The constants: variable 1, which the first clause makes true.
  static constexpr Literal yes = 1;
  static constexpr Literal no = -1;

  Literal input() { return ++cnf_.variables; }
  Literal all_of(Clause terms);
  Literal any_of(Clause terms);
  /// result[m]: at least m of the terms are true, 0 <= m <= terms.size() + 1.
  std::vector<Literal> at_least(const std::vector<Literal>& terms);

  /// Asserts that one of the literals is true.
  void require(Clause clause);

  const Cnf& cnf() const { return cnf_; }

 private:
  Cnf cnf_;
};

}  // namespace restrip::verify::sat
