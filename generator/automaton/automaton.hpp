// A finite automaton for all fans: arcs of any length fall into finitely many classes (docs/explanation/automaton.md).
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "automaton/arc.hpp"
#include "tables/layout.hpp"

namespace restrip::generator {

/// The result of a letter.
struct ArcStep {
  std::size_t to = 0;                     ///< a class
  int cost = 0;                           ///< of the best case of `to`, minus the cost of this class's best case
  std::array<Case, case_codes> before{};  ///< for each case of `to`: the case of this class from which it came
};

/// Arcs that no continuation, no other arc and no tie-break distinguishes.
struct ArcClass {
  std::string witness;    ///< its shortest arc, letter by letter; the first one in the order of letters
  bool boundary = false;  ///< the mesh boundary is inside
  /// For each case that some best recolouring needs, its cost minus the least of them; empty for other cases.
  Costs costs;
  std::vector<std::optional<ArcStep>> steps;  ///< by letter; empty for a second boundary
  std::size_t as_first = 0;                   ///< arcs with equal numbers have equal meetings with every second arc
  std::size_t as_second = 0;                  ///< the same for the second arc
  std::optional<Case> closing;                ///< as a whole closed fan; not with the boundary inside

  /// Whether it can lie between A and D; every arc except the empty one can lie between D and A.
  [[nodiscard]] bool can_be_first() const { return !witness.empty() && !boundary; }
};

/// Their numbers before and after minimisation.
struct AutomatonCounts {
  std::size_t values = 0;         ///< different sets of relative costs of arcs without boundary, except the empty arc
  std::size_t with_ports = 0;     ///< the same, with end ports distinguished as well
  std::size_t with_boundary = 0;  ///< the same, including arcs with the boundary inside
};

struct Automaton {
  std::vector<ArcClass> classes;  ///< in order of witness, shorter ones first; number 0 is the empty arc alone
  AutomatonCounts counts;
  /// By as_first and as_second.
  std::vector<std::vector<Meeting>> meets;
};

[[nodiscard]] Automaton make_automaton();

// The automaton's certificate, and its numbers as arrays.

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
