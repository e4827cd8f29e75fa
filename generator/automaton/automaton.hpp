// Every fan in one finite automaton: arcs fall into finitely many classes, whatever their length
// (docs/explanation/automaton.md).
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "automaton/arc.hpp"
#include "automaton/meeting.hpp"

namespace restrip::generator {

/// What a letter leads to.
struct ArcStep {
  std::size_t to = 0;                     ///< a class
  int cost = 0;                           ///< of the best case of `to`, more than that of this class
  std::array<Case, case_codes> before{};  ///< for each case that `to` has: the case of this class that it came from
};

/// Arcs that no continuation, no other arc and no tie-break tells apart.
struct ArcClass {
  std::string witness;    ///< its shortest arc, letter by letter; the first in the order of letters of the shortest
  bool boundary = false;  ///< the mesh boundary is inside
  /// For each case that some best recolouring needs its cost, less the least of them; nothing for the other cases.
  Costs costs;
  std::vector<std::optional<ArcStep>> steps;  ///< by letter; nothing for a second boundary
  std::size_t as_first = 0;                   ///< arcs with equal numbers meet every second arc alike
  std::size_t as_second = 0;                  ///< the same the other way round
  std::optional<Case> closing;                ///< as a whole closed fan; not with the boundary inside

  /// Whether it can lie between A and D; any arc but the empty one can lie between D and A.
  [[nodiscard]] bool can_be_first() const { return !witness.empty() && !boundary; }
};

/// How many there are before and after.
struct AutomatonCounts {
  std::size_t values = 0;      ///< different sets of relative costs, of arcs without boundary, the empty one left out
  std::size_t with_ports = 0;  ///< the same, where end ports are distinguished as well
  std::size_t with_boundary = 0;  ///< the same, with arcs that have the boundary inside
};

struct Automaton {
  std::vector<ArcClass> classes;  ///< in order of witness, shorter ones first; number 0 is the empty arc alone
  AutomatonCounts counts;
  /// By as_first and as_second.
  std::vector<std::vector<Meeting>> meets;
};

[[nodiscard]] Automaton make_automaton();

}  // namespace restrip::generator
