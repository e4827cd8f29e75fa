#include "naive_rup.hpp"

#include <algorithm>
#include <cstdlib>
#include <set>

namespace restrip::verify::sat::test {

Propagation propagate(const std::vector<Clause>& clauses, int variables, const std::vector<Literal>& facts) {
  Propagation result{false, std::vector<int>(static_cast<std::size_t>(variables) + 1, 0)};
  const auto value = [&](Literal literal) {
    const int known = result.value[static_cast<std::size_t>(std::abs(literal))];
    return literal > 0 ? known : -known;
  };
  const auto set = [&](Literal literal) {
    result.value[static_cast<std::size_t>(std::abs(literal))] = literal > 0 ? 1 : -1;
  };
  for (const Literal fact : facts) {
    if (value(fact) < 0) result.conflict = true;
    set(fact);
  }
  for (bool moved = true; moved && !result.conflict;) {
    moved = false;
    for (const Clause& clause : clauses) {
      std::set<Literal> open;
      bool satisfied = false;
      for (const Literal literal : clause) {
        satisfied = satisfied || value(literal) > 0;
        if (value(literal) == 0) open.insert(literal);
      }
      if (satisfied) continue;
      if (open.empty()) result.conflict = true;
      if (open.size() != 1) continue;
      set(*open.begin());
      moved = true;
    }
  }
  return result;
}

bool naively_proved(const Cnf& cnf, const Proof& proof) {
  std::vector<Clause> clauses = cnf.clauses;
  for (const ProofStep& step : proof) {
    const std::set<Literal> wanted(step.clause.begin(), step.clause.end());
    if (step.deletes) {
      const auto found = std::find_if(clauses.begin(), clauses.end(), [&](const Clause& clause) {
        return std::set<Literal>(clause.begin(), clause.end()) == wanted;
      });
      if (found == clauses.end()) return false;
      clauses.erase(found);
      continue;
    }
    std::vector<Literal> denied;
    for (const Literal literal : wanted) denied.push_back(-literal);
    if (!propagate(clauses, cnf.variables, denied).conflict) return false;
    if (step.clause.empty()) return true;
    clauses.push_back(step.clause);
  }
  return false;
}

}  // namespace restrip::verify::sat::test
