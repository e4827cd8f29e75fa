#include "sat/proof_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "sat/rup.hpp"

namespace restrip::verify::sat {
namespace {

constexpr std::size_t of_the_formula = std::numeric_limits<std::size_t>::max();

/// Follows the clauses used back from the empty clause.
std::vector<std::size_t> core_of(const std::vector<std::vector<RupClauses::Id>>& used_by_step,
                                 const std::vector<std::size_t>& step_of_clause) {
  std::vector<bool> needed(used_by_step.size(), false);
  needed.back() = true;
  std::vector<std::size_t> core;
  for (std::size_t step = used_by_step.size(); step-- > 0;) {
    if (!needed[step]) continue;
    core.push_back(step);
    for (const RupClauses::Id id : used_by_step[step])
      if (step_of_clause[id] != of_the_formula) needed[step_of_clause[id]] = true;
  }
  std::reverse(core.begin(), core.end());
  return core;
}

}  // namespace

ProofVerdict check_proof(const Cnf& cnf, const Proof& proof) {
  RupClauses clauses(cnf.variables);
  std::vector<std::size_t> step_of_clause(cnf.clauses.size(), of_the_formula);
  for (const Clause& clause : cnf.clauses) clauses.add(clause);

  std::vector<std::vector<RupClauses::Id>> used_by_step;
  for (std::size_t step = 0; step < proof.size(); ++step) {
    const ProofStep& next = proof[step];
    used_by_step.emplace_back();
    if (next.deletes) {
      if (!clauses.remove(next.clause))
        return {false, fmt::format("line {}: deletes a clause that is not there", next.line), {}};
      continue;
    }
    auto used = clauses.used_to_derive(next.clause);
    if (!used) return {false, fmt::format("line {}: does not follow by unit propagation", next.line), {}};
    used_by_step.back() = std::move(*used);
    if (next.clause.empty()) return {true, {}, core_of(used_by_step, step_of_clause)};
    clauses.add(next.clause);
    step_of_clause.push_back(step);
  }
  return {false, "the empty clause is missing", {}};
}

}  // namespace restrip::verify::sat
