// Two arcs around A and D, or one arc around a fan: the best combination of their cases
// (docs/explanation/automaton.md).
#pragma once

#include <compare>
#include <cstddef>
#include <optional>
#include <vector>

#include "automaton/arc.hpp"

namespace restrip::generator {

/// The properties of an arc's solid ports that determine which pairs of end ports are pairs of the key.
struct Ports {
  unsigned count = 0;         ///< 3 stands for three or more
  bool first_joined = false;  ///< the first one is joined to the solid port before it, which lies outside the arc
  bool two_joined = false;    ///< it has exactly two, and they are joined
  friend constexpr auto operator<=>(const Ports&, const Ports&) = default;
};
[[nodiscard]] Ports with_letter(Ports ports, Letter letter);

/// An arc with all cases that some patch may need; costs minus the least.
struct Arc {
  Costs costs;
  Ports ports;
  bool boundary = false;  ///< the mesh boundary is inside
  friend auto operator<=>(const Arc&, const Arc&) = default;
};

/// The choice for two arcs around A and D, in ring order A, first, D, second.
struct Meeting {
  Case first = both_dashed;
  Case second = both_dashed;
  bool chord = false;
};

/// All meetings that are sound for some arcs, in order of preference, and the best of them for two arcs.
class Meetings {
 public:
  Meetings();

  [[nodiscard]] const Meeting& operator[](std::size_t number) const { return combinations_[number].meeting; }
  /// Its number.
  [[nodiscard]] std::size_t best(const Arc& first, const Arc& second) const;

 private:
  struct Combination {
    Meeting meeting;
    int cost = 0;        ///< the cost of A, D and the edges that no arc counts
    unsigned joins = 0;  ///< pairs of ends whose strands reach ports and are joined
    int tie = 0;         ///< smaller is preferred
  };
  static std::optional<Combination> combination_of(const Meeting& meeting);

  std::vector<Combination> combinations_;
};

/// The best case of an arc that is a whole closed fan, so that its two links are one edge.
[[nodiscard]] Case best_closing(const Arc& arc);

}  // namespace restrip::generator
