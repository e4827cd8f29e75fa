#include "sat/proof_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <limits>

#include "sat/rup.hpp"

namespace restrip::verify::sat {
namespace {

constexpr std::size_t of_the_formula = std::numeric_limits<std::size_t>::max();

/// Follows the clauses used back from the empty clause.
ProofVerdict core_of(const std::vector<std::vector<RupClauses::Id>>& used_by_step,
                     const std::vector<std::size_t>& step_of_clause, std::size_t in_formula) {
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

  std::vector<std::size_t> number_of_step(used_by_step.size(), 0);
  for (std::size_t i = 0; i < core.size(); ++i) number_of_step[core[i]] = in_formula + 1 + i;
  std::vector<std::vector<std::size_t>> hints;
  for (const std::size_t step : core) {
    hints.emplace_back();
    // The clauses used are listed from the conflict back.
    for (auto id = used_by_step[step].rbegin(); id != used_by_step[step].rend(); ++id)
      hints.back().push_back(step_of_clause[*id] == of_the_formula ? *id + std::size_t{1}
                                                                   : number_of_step[step_of_clause[*id]]);
  }
  return {true, {}, std::move(core), std::move(hints)};
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
        return {false, fmt::format("line {}: deletes a clause that is not there", next.line), {}, {}};
      continue;
    }
    auto used = clauses.used_to_derive(next.clause);
    if (!used) return {false, fmt::format("line {}: does not follow by unit propagation", next.line), {}, {}};
    used_by_step.back() = std::move(*used);
    if (next.clause.empty()) return core_of(used_by_step, step_of_clause, cnf.clauses.size());
    clauses.add(next.clause);
    step_of_clause.push_back(step);
  }
  return {false, "the empty clause is missing", {}, {}};
}

std::string lrat_of(const Cnf& cnf, const Proof& proof, const ProofVerdict& verdict) {
  fmt::memory_buffer text;
  for (std::size_t i = 0; i < verdict.core.size(); ++i) {
    fmt::format_to(std::back_inserter(text), "{} ", cnf.clauses.size() + 1 + i);
    for (const Literal literal : proof[verdict.core[i]].clause)
      fmt::format_to(std::back_inserter(text), "{} ", literal);
    fmt::format_to(std::back_inserter(text), "0 ");
    for (const std::size_t hint : verdict.hints[i]) fmt::format_to(std::back_inserter(text), "{} ", hint);
    fmt::format_to(std::back_inserter(text), "0\n");
  }
  return fmt::to_string(text);
}

}  // namespace restrip::verify::sat
