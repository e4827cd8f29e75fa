// Two arcs around A and D as a small graph. Each arc is represented by its case: a strand over each solid link that
// ends, leaves by a port or goes through. Also one arc whose links meet each other.
#pragma once

#include <string_view>
#include <vector>

#include "automaton/arc.hpp"

namespace restrip::verify {

/// The links of two arcs in ring order A, first arc, D, second arc.
enum ArcEnd : unsigned { first_left, first_right, second_left, second_right };

/// A combination of two cases.
struct ArcWay {
  bool legal = false;  ///< degrees at most two, no cycle
  int cost = 0;        ///< cost not counted in the arcs
  Mask joined = 0;     ///< pairs of links whose strands leave by ports and are joined
};

/// All combinations of arcs. Cases by number.
class ArcWays {
 public:
  ArcWays();

  /// Around A and D, in ring order A, first, D, second.
  const ArcWay& around(std::size_t first, std::size_t second, bool chord) const {
    return around_[2 * (case_count * first + second) + (chord ? 1U : 0U)];
  }
  /// A closed fan: the two links of an arc are one edge.
  const ArcWay& closed(std::size_t arc_case) const { return closed_[arc_case]; }

 private:
  std::vector<ArcWay> around_;
  std::vector<ArcWay> closed_;
};

/// Whether, in the ring A, first, D, second of these letters, the ports that two links reach are joined before the
/// operation. A solid port may be joined to the solid port before it in the ring, according to its letter.
bool joined_before(std::string_view first, std::string_view second, ArcEnd one, ArcEnd other);
/// All pairs of links for which that is true.
Mask pairs_joined_before(std::string_view first, std::string_view second);

}  // namespace restrip::verify
