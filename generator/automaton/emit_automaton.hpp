// The text of the automaton's files: a constexpr header, a certificate, and figures as JSON. Same input, same bytes.
#pragma once

#include <string>

#include "automaton/automaton.hpp"
#include "tables/emit.hpp"
#include "tables/layout.hpp"

namespace restrip::generator {

/// restrip/tables/automaton.hpp.
[[nodiscard]] RulesHeader automaton_header(const Automaton& automaton);

/// certificates/automaton.cert, with the number of its rows.
struct AutomatonCertificate {
  std::string text;
  std::size_t rows = 0;
};
[[nodiscard]] AutomatonCertificate automaton_certificate(const Automaton& automaton);

/// The numbers of the header for other languages (languages/): `next` has 0 for a letter that is not allowed, so that
/// every entry is a class, and a number of `before` is two words, the low one first.
struct AutomatonArrays {
  std::size_t seconds = 0;  ///< columns of `meet`
  TableLayout table;
};
[[nodiscard]] AutomatonArrays automaton_arrays(const Automaton& automaton);

/// The numbers of classes before and after minimisation, letters, cases, bytes.
[[nodiscard]] std::string automaton_json(const Automaton& automaton);

/// Every class as JSON, for pictures: its witness, and for each of its cases the cost and a best colouring, as the
/// colours of the links from left to right.
[[nodiscard]] std::string classes_json(const Automaton& automaton);

}  // namespace restrip::generator
