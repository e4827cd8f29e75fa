#pragma once
// Compares the two formulations, worlds and forbidden sets, on every configuration, on every (configuration,
// recolouring) pair, on every optimum.

#include "judge/forbidden_sets.hpp"
#include "judge/rule_judge.hpp"

namespace restrip::verify {

struct Agreement {
  std::uint64_t configurations = 0;
  std::uint64_t pairs = 0;
  std::uint64_t optima = 0;
  std::uint64_t hitting_set_problems = 0;
  Failures disagreements;
};

/// Forbidden sets are those of strips, and smallest hitting sets leave fewest strips.
inline bool has_second_formulation(const Operation& operation) {
  return operation.constraint == Constraint::strips && may_have_reasons(operation);
}

/// Of an operation that is searched.
Agreement second_opinion_on(const RuleJudge& judge);

}  // namespace restrip::verify
