// Every fan in one finite automaton: arcs fall into finitely many classes, whatever their length (docs/automaton.md).
#pragma once

#include <array>
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
  Value gain;                             ///< of the best case of this class, to the best case of that one
  std::array<Case, case_codes> before{};  ///< for each case that `to` has: the case of this class that it came from
};

/// Arcs that no continuation, no other arc and no tie-break tells apart.
struct ArcClass {
  std::string witness;    ///< its shortest arc, letter by letter; the first in the order of letters of the shortest
  bool boundary = false;  ///< the mesh boundary is inside
  /// For each case that some best recolouring needs its value, less the best of them; nothing for the other cases.
  Values values;
  std::array<std::optional<ArcStep>, 4> steps;  ///< by letter; nothing for a second boundary
  std::size_t as_first = 0;                     ///< arcs with equal numbers meet every second arc alike
  std::size_t as_second = 0;                    ///< the same the other way round
  Closing closing;  ///< as a whole closed fan, from the best case; not with a boundary inside
};

/// How many there are before and after.
struct AutomatonCounts {
  std::size_t values = 0;      ///< different sets of relative values, of arcs without boundary, the empty one left out
  std::size_t with_ports = 0;  ///< the same, where end ports are told apart as well
  std::size_t with_boundary = 0;  ///< the same, with arcs that have the boundary inside
};

struct Automaton {
  std::vector<ArcClass> classes;  ///< in order of witness, shorter ones first; number 0 is the empty arc alone
  AutomatonCounts counts;
  std::vector<Meeting> meetings;  ///< those that occur
  /// By as_first and as_second, an index into `meetings`.
  std::vector<std::vector<std::size_t>> meets;
  /// By class, from the two best cases; of arcs with at least one triangle, the first without boundary.
  [[nodiscard]] ValuedMeeting meeting(std::size_t first, std::size_t second) const;
};

[[nodiscard]] Automaton make_automaton();

}  // namespace restrip::generator
