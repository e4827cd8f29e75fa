// Text of the index automaton's files: a constexpr header, a certificate, figures as JSON. Same input, same bytes.
#pragma once

#include <string>

#include "automaton/automaton_text.hpp"
#include "automaton/index_automaton.hpp"
#include "emit.hpp"

namespace restrip::generator::indices {

/// restrip/tables/index_automaton.hpp. std::invalid_argument when a number does not fit its type.
[[nodiscard]] RulesHeader automaton_header(const Automaton& automaton);

/// certificates/index-automaton.cert, with the number of its rows.
[[nodiscard]] AutomatonCertificate automaton_certificate(const Automaton& automaton);

/// Weights, classes, letters, cases, bytes.
[[nodiscard]] std::string automaton_json(const Automaton& automaton);

/// Every class as JSON, for pictures: its witness, and for each of its cases the cost and a best colouring, the colours
/// of the links from left to right.
[[nodiscard]] std::string classes_json(const Automaton& automaton);

}  // namespace restrip::generator::indices
