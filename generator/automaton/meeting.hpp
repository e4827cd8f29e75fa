// Two arcs around A and D, or one arc around a fan: the best way to put their cases together
// (docs/explanation/automaton.md).
#pragma once

#include <compare>
#include <cstddef>
#include <optional>
#include <vector>

#include "automaton/arc.hpp"

namespace restrip::generator {

/// What must be known of the solid ports of an arc to say which pairs of end ports are pairs of the key.
struct Ports {
  unsigned count = 0;         ///< 3 stands for three or more
  bool first_joined = false;  ///< the first one is joined to the solid port before it, which lies outside the arc
  bool two_joined = false;    ///< there are exactly two, and they are joined
  friend constexpr auto operator<=>(const Ports&, const Ports&) = default;
};
[[nodiscard]] Ports with_letter(Ports ports, Letter letter);

/// An arc as a part of a patch sees it.
struct Arc {
  Arc(const Costs& costs, Ports of);

  struct CaseCost {
    Case arc = both_dashed;
    int cost = 0;
  };
  std::vector<CaseCost> cases;  ///< those that it has
  Ports ports;
};

/// What two arcs do around A and D, in ring order A, first, D, second.
struct Meeting {
  Case first = both_dashed;
  Case second = both_dashed;
  bool chord = false;
  friend constexpr auto operator<=>(const Meeting&, const Meeting&) = default;
};

/// All meetings that are sound for some arcs, preferred ones first, and the best of them for two arcs.
class Meetings {
 public:
  Meetings();

  [[nodiscard]] const Meeting& operator[](std::size_t number) const { return ways_[number].meeting; }
  /// Its number.
  [[nodiscard]] std::size_t best(const Arc& first, const Arc& second) const;

 private:
  struct Way {
    Meeting meeting;
    int cost = 0;        ///< what A, D and the edges that no arc counts add to the costs of the two arcs
    unsigned joins = 0;  ///< pairs of ends whose strands reach ports and are joined
    int tie = 0;         ///< smaller is preferred
  };
  static std::optional<Way> way_of(const Meeting& meeting);

  std::vector<Way> ways_;
  std::vector<int> number_of_;  ///< by cases and chord; -1 where not sound
};

/// The best case of an arc that is a whole closed fan, its two links being one edge.
[[nodiscard]] Case best_closing(const Arc& arc);

}  // namespace restrip::generator
