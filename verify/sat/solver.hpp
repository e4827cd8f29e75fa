#pragma once
// Running the SAT solver and, when the user names one, another proof checker.

#include <optional>
#include <string>
#include <vector>

#include "sat/cnf.hpp"

namespace restrip::verify::sat {

/// What a solver found: an assignment, value[variable], or nothing when it says that there is none.
using Model = std::optional<std::vector<bool>>;

/// Runs `solver -q --no-binary FORMULA PROOF`, which CaDiCaL and Kissat understand; PROOF is written when there is no
/// model. Throws std::runtime_error when the solver cannot be run or does not answer. `answer` is a file to write its
/// words to.
Model solve(const std::string& solver, const std::string& formula, const std::string& proof, const std::string& answer,
            int variables);

/// Runs `checker FORMULA PROOF`; true when it succeeds and says "s VERIFIED", as drat-trim does.
bool foreign_checker_agrees(const std::string& checker, const std::string& formula, const std::string& proof,
                            const std::string& answer);

}  // namespace restrip::verify::sat
