// Why no sound recolouring is preferred to a rule's: the reasons that certificates give (docs/certificate.md,
// "Reasons"). A reason is a case tree; docs/trust.md proves that it is one.
#pragma once

#include <string>
#include <vector>

#include "solve/search.hpp"

namespace restrip::generator {

/// Edges of the side after an operation: inner edges first; then the ports, of which those count that may be given up.
using EdgeSet = Mask;

/// Either two cases, an edge solid and the same edge dashed, or disjoint sets of edges that cannot all be solid.
struct Reason {
  unsigned edge = 0;
  std::vector<Reason> cases;  ///< solid, dashed; empty for a leaf
  std::vector<EdgeSet> sets;  ///< of a leaf: smallest sets, in ascending order of (size, set)

  [[nodiscard]] std::size_t leaves() const;
  /// The reason as certificates write it.
  [[nodiscard]] std::string text() const;
};

/// Whether reasons can be given for the rules of an operation: strips or forests, preferred by fewest_strips() first.
[[nodiscard]] bool has_reasons(const Operation& operation);

/// Finds reasons for the rules of one operation that has them.
class Reasoner {
 public:
  explicit Reasoner(const Operation& operation);

  /// A reason with as few leaves as possible; the first one in a fixed order. `best` must be the best choice for these
  /// solid ports and pairs that were joined before (two bits each). Exponential in the leaves, of which the best rules
  /// of fans of up to eight triangles need five at most.
  [[nodiscard]] Reason reason(Mask ports, const std::vector<Mask>& joined, const Choice& best) const;

 private:
  /// Edges that cannot all be solid, unless `pair` was joined before; ports come after the inner edges here, always.
  struct Forbidden {
    EdgeSet edges = 0;
    Mask pair = 0;
  };
  /// What is to be shown: at least so many edges are dashed, and if it is just so many, then so many triangles are
  /// isolated at least, and so on.
  struct Goal {
    EdgeSet edges = 0;  ///< those that a recolouring may leave dashed
    std::vector<EdgeSet> sets;
    std::vector<EdgeSet> triangles;
    int dashed = 0;
    int isolated = 0;
    int given_up = 0;
  };
  [[nodiscard]] Goal goal_of(Mask ports, const std::vector<Mask>& joined, const Choice& best) const;
  [[nodiscard]] bool find(const Goal& goal, EdgeSet solid, EdgeSet dashed, std::size_t leaves, Reason& reason) const;
  [[nodiscard]] bool find_leaf(const Goal& goal, EdgeSet solid, EdgeSet dashed, Reason& reason) const;

  Mask may_give_up_;
  Side after_;
  std::vector<Forbidden> forbidden_;
};

}  // namespace restrip::generator
