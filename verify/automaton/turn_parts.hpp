#pragma once
// How arcs are put together under a cost with swaps: an arc and a triangle behind it, two arcs around A and D, two arcs
// around A alone, one arc around a closed fan. What the first adds is observed in all short arcs; the others are laid
// down as small graphs, of each arc its case.

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "judgment.hpp"
#include "turn_arc.hpp"

namespace restrip::verify {

/// An arc and a triangle behind it.
struct TurnJoint {
  bool sound = false;
  std::size_t arc_case = 0;
  bool swap = false;  ///< the link between them is one
  friend bool operator==(const TurnJoint&, const TurnJoint&) = default;
};

/// What becomes of the case of an arc and that of a triangle behind it: read off all colourings of all words of up to
/// `longest` letters. It is a failure when two colourings with the same cases disagree, in the case of the whole, in
/// what it costs or in soundness, or when the longest words show something new.
class TurnJoints {
 public:
  explicit TurnJoints(std::size_t longest);

  /// Nothing where links of different colours meet.
  const std::optional<TurnJoint>& at(std::size_t arc_case, std::size_t triangle_case, bool joined) const {
    return joints_[2 * (turn_cases * arc_case + triangle_case) + (joined ? 1U : 0U)];
  }
  std::uint64_t colorings() const { return colorings_; }
  const Failures& failures() const { return failures_; }

 private:
  void observe(const std::string& word, Mask links, bool may_be_new);

  std::vector<std::optional<TurnJoint>> joints_;
  std::uint64_t colorings_ = 0;
  Failures failures_;
};

/// Pairs of links, one bit each, that strands join from port to port; of the ends of two arcs there are six.
inline constexpr std::size_t pair_sets = 64;

/// Two cases put together.
struct TurnWay {
  bool legal = false;  ///< degrees at most two, no cycle
  int cost = 0;        ///< of what no arc counts
  Mask joined = 0;     ///< pairs of links
};

/// All ways to put arcs together, for given weights. Cases by number.
class TurnWays {
 public:
  explicit TurnWays(const TurnWeights& weights);

  /// Around A and D, in ring order A, first, D, second.
  const TurnWay& around(std::size_t first, std::size_t second, bool chord) const {
    return around_[2 * (turn_cases * first + second) + (chord ? 1U : 0U)];
  }
  /// Around A alone: an arc whose left link is dashed, A, an arc whose right link is dashed. Bit 0 of `joined` is their
  /// pair of links.
  const TurnWay& one_between(std::size_t before, std::size_t behind) const {
    return one_between_[turn_cases * before + behind];
  }
  /// A closed fan. Bit 0 of `joined` is the pair of its links.
  const TurnWay& closed(std::size_t arc_case) const { return closed_[arc_case]; }

 private:
  std::vector<TurnWay> around_;
  std::vector<TurnWay> one_between_;
  std::vector<TurnWay> closed_;
};

/// The bit of a pair of ends: 0, 1 the left and the right link of the first arc, 2, 3 those of the second.
Mask pair_of_ends(unsigned one, unsigned other);

}  // namespace restrip::verify
