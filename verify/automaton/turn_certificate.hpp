#pragma once
// The index automaton's certificate in memory, and its parser (docs/automaton.md, "Certificate of the index
// automaton"). The parser settles form; whether a row is true is checked elsewhere.

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "turn_arc.hpp"

namespace restrip::verify {

struct TurnStep {
  std::size_t to = 0;
  int cost = 0;
  std::array<std::size_t, turn_cases> from{};  ///< for each case that `to` has
  unsigned line = 0;
};

struct TurnClass {
  std::string witness;
  TurnCosts costs;
  std::array<TurnStep, turn_letters.size()> steps;  ///< by letter
  unsigned line = 0;
};

struct TurnCertificate {
  std::string file;
  TurnWeights weights;
  std::vector<TurnClass> classes;
  std::size_t rows = 0;
};

/// InputError when anything is not as docs/automaton.md says.
TurnCertificate parse_turn_automaton(const std::string& file, std::string text);

}  // namespace restrip::verify
