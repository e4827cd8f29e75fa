// Every fan under a cost with swaps in one finite automaton (docs/automaton.md). Arcs are classes by what each case
// costs; how two classes meet follows from these costs, so there is no table of pairs.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "automaton/index_arc.hpp"

namespace restrip::generator::indices {

/// What a letter leads to.
struct ArcStep {
  std::size_t to = 0;                     ///< a class
  int cost = 0;                           ///< of the best case of `to`, more than that of this class
  std::array<Case, case_codes> before{};  ///< for each case that `to` has: the case of this class that it came from
};

/// Arcs with the same relative costs.
struct ArcClass {
  std::string witness;  ///< its shortest arc, letter by letter; the first in the order of letters of the shortest
  Costs costs;          ///< of the cases that cannot be exchanged without loss, less the least
  std::array<ArcStep, all_letters.size()> steps;  ///< by letter
};

struct Automaton {
  Weights weights;
  std::vector<ArcClass> classes;  ///< in order of witness, shorter ones first; number 0 is the empty arc alone
  /// Classes before dispensable cases are dropped, the empty one left out; nothing when they are more than the limit.
  std::optional<std::size_t> undropped;
};

/// The most that a compiled automaton can number: 16 bits hold a class and a letter.
inline constexpr std::size_t most_classes = 65535 / all_letters.size();

/// std::invalid_argument with a remedy when the weights need more than `most_classes`.
[[nodiscard]] Automaton make_automaton(const Weights& weights);

}  // namespace restrip::generator::indices
