// The search for a reason (reason.hpp): a case tree that shows that so many edges must stay dashed.
#pragma once

#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include "solve/reason.hpp"

namespace restrip::generator {

/// What is to be shown: at least so many edges are dashed, and if it is just so many, then so many triangles are
/// isolated at least, and so on.
struct ReasonGoal {
  EdgeSet edges = 0;               ///< those that a recolouring may leave dashed
  unsigned inner_edges = 0;        ///< edges from this number on are ports
  std::vector<EdgeSet> sets;       ///< none of them can be all solid
  std::vector<EdgeSet> triangles;  ///< each is isolated when all of these are dashed
  int dashed = 0;
  int isolated = 0;
  int given_up = 0;
};

/// Looks for reasons of one goal, and counts its steps: a state looked at, or a set looked at in a state, is one. A
/// state says which edges are settled as solid and which as dashed.
class ReasonSearch {
 public:
  explicit ReasonSearch(const ReasonGoal& goal) : goal_(goal) {}

  /// The first smallest tree in a fixed order; none when that takes more steps than these. Exponential in the leaves.
  [[nodiscard]] std::optional<Reason> smallest(std::uint64_t most_steps);

  /// A tree that need not be smallest: it tells cases by the edge that is in most small sets.
  [[nodiscard]] Reason greedy();

  [[nodiscard]] std::uint64_t steps() const { return steps_; }

 private:
  struct Known {
    std::size_t too_few = 0;  ///< no tree has so many leaves
    std::optional<Reason> reason;
  };

  /// Sets of the goal that still say something, none of which contains another.
  [[nodiscard]] std::vector<EdgeSet> open_sets(EdgeSet solid, EdgeSet dashed);
  [[nodiscard]] std::optional<Reason> leaf(const std::vector<EdgeSet>& sets, EdgeSet dashed);
  [[nodiscard]] bool choose_disjoint(const std::vector<EdgeSet>& sets, std::size_t from, int count, EdgeSet taken,
                                     std::vector<EdgeSet>& chosen);
  /// A tree of at most so many leaves, of which no tree has fewer; null when there is none, or steps are used up.
  [[nodiscard]] const Reason* find(EdgeSet solid, EdgeSet dashed, std::size_t leaves);
  [[nodiscard]] Reason greedy(EdgeSet solid, EdgeSet dashed);

  const ReasonGoal& goal_;
  std::unordered_map<std::uint64_t, Known> known_;
  std::uint64_t steps_ = 0;
  std::uint64_t last_step_ = 0;
};

}  // namespace restrip::generator
