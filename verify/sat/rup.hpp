#pragma once
// Reverse unit propagation: does a clause follow from others by nothing but "all but one of my literals are false, so
// the last one is true"? Goldberg and Novikov, "Verification of proofs of unsatisfiability for CNF formulas", 2003.
// Two literals of each clause are watched (Moskewicz and others, "Chaff", 2001).

#include <cstddef>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include "sat/cnf.hpp"

namespace restrip::verify::sat {

class RupClauses {
 public:
  using Id = std::uint32_t;

  explicit RupClauses(int variables);

  /// Clauses count from 0 in the order in which they are added. Repeated literals are dropped.
  Id add(Clause clause);
  /// One copy of the clause, its literals in any order; false when there is none.
  bool remove(Clause clause);

  /// Whether the clause follows: assume that it is false, propagate, and wait for a clause that is false altogether.
  /// The answer holds the clauses that were used, or nothing when propagation ends without a contradiction.
  std::optional<std::vector<Id>> used_to_derive(const Clause& clause);

 private:
  enum class Value : std::uint8_t { open, yes, no };
  static constexpr Id none = static_cast<Id>(-1);

  static std::size_t index(Literal literal) {
    return literal > 0 ? 2 * static_cast<std::size_t>(literal) : 2 * static_cast<std::size_t>(-literal) + 1;
  }
  static std::size_t variable(Literal literal) { return static_cast<std::size_t>(literal > 0 ? literal : -literal); }

  /// False when the literal is false already.
  bool assign(Literal literal, Id reason);
  /// The clause that became false, or none.
  Id propagate();
  Id propagate_one(Literal false_literal);
  Id assign_units();
  std::vector<Id> used_for(Id conflict);
  void forget_assignment();

  std::vector<Clause> clauses_;  ///< the two watched literals come first; removed clauses are emptied
  std::unordered_multimap<std::uint64_t, Id> by_hash_;
  std::vector<std::vector<Id>> watchers_;  ///< by index(literal)
  std::vector<Id> short_;                  ///< clauses of one literal or none
  std::vector<Value> value_;               ///< by index(literal)
  std::vector<Id> reason_;                 ///< by variable
  std::vector<bool> seen_;                 ///< by variable
  std::vector<Literal> trail_;
  std::size_t propagated_ = 0;
};

}  // namespace restrip::verify::sat
