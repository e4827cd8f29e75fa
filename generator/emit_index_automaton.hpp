// Text of the index automaton's files: a constexpr header, a certificate, figures as JSON. Same input, same bytes.
#pragma once

#include <cstddef>
#include <string>

#include "emit.hpp"
#include "index_automaton.hpp"

namespace restrip::generator::indices {

/// restrip/tables/index_automaton.hpp. std::invalid_argument when a number does not fit its type.
[[nodiscard]] RulesHeader automaton_header(const Automaton& automaton);

/// certificates/index-automaton.cert, with the number of its rows.
struct AutomatonCertificate {
  std::string text;
  std::size_t rows = 0;
};
[[nodiscard]] AutomatonCertificate automaton_certificate(const Automaton& automaton);

/// Weights, classes, letters, cases, bytes; and for pictures some witnesses with their costs by case.
[[nodiscard]] std::string automaton_json(const Automaton& automaton);

}  // namespace restrip::generator::indices
