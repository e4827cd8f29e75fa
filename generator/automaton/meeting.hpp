// Two arcs around A and D, or one arc around a fan: the best way to put their cases together (docs/automaton.md).
#pragma once

#include <compare>
#include <optional>

#include "automaton/arc.hpp"

namespace restrip::generator {

/// What must be known of the solid ports of an arc to tell which pairs of end ports are pairs of the key.
struct Ports {
  unsigned count = 0;         ///< 3 stands for three or more
  bool first_joined = false;  ///< the first one is joined to the solid port before it, which lies outside the arc
  bool two_joined = false;    ///< there are exactly two, and they are joined
  friend constexpr auto operator<=>(const Ports&, const Ports&) = default;
};
[[nodiscard]] Ports with_letter(Ports ports, Letter letter);

/// An arc as a part of a patch sees it.
struct Arc {
  Values values;
  Ports ports;
};

/// What two arcs do around A and D, in ring order A, first, D, second.
struct Meeting {
  Case first = both_dashed;
  Case second = both_dashed;
  bool chord = false;
  friend constexpr auto operator<=>(const Meeting&, const Meeting&) = default;
};
struct ValuedMeeting {
  Meeting meeting;
  Value value;
};
/// What A, D and the edges that no arc counts add to the values of the two arcs.
[[nodiscard]] Value value_around(const Meeting& meeting);

[[nodiscard]] ValuedMeeting best_meeting(const Arc& first, const Arc& second);

/// The case of an arc that is a whole closed fan, its two links being one edge.
struct Closing {
  Case arc = both_dashed;
  Value value;
};
[[nodiscard]] Closing best_closing(const Arc& arc);

}  // namespace restrip::generator
