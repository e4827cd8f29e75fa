// The automaton's certificate, and its numbers as arrays.
#pragma once

#include <string>

#include "automaton/automaton.hpp"
#include "tables/layout.hpp"

namespace restrip::generator {

/// certificates/automaton.cert, with the number of its rows.
struct AutomatonCertificate {
  std::string text;
  std::size_t rows = 0;
};
[[nodiscard]] AutomatonCertificate automaton_certificate(const Automaton& automaton);

/// The numbers for other languages: `next` has 0 for a letter that is not allowed, so that every entry is a class, and
/// a number of `before` is two words, the low one first.
struct AutomatonArrays {
  std::size_t seconds = 0;  ///< columns of `meet`
  TableLayout table;
};
[[nodiscard]] AutomatonArrays automaton_arrays(const Automaton& automaton);

}  // namespace restrip::generator
