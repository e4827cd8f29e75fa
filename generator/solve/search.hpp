// Exhaustive search: the best sound recolouring for every key.
#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "operations/operation.hpp"
#include "solve/coloring.hpp"

namespace restrip::generator {

/// The colours after an operation.
struct Choice {
  Mask recoloring = 0;
  Mask kept = 0;          ///< ports that stay solid
  unsigned solid = 0;     ///< solid inner edges
  unsigned isolated = 0;  ///< isolated triangles; a port given up counts as one
};

/// By solid ports: the pairs that some valid recolouring joins. For other pairs it does not matter whether they were
/// joined.
[[nodiscard]] std::vector<PortPairs> relevant_pairs(const Operation& operation);

/// The values of the criteria, followed by the tie-break; smaller is better, compared lexicographically.
using CriterionValues = std::array<std::int64_t, most_criteria + 1>;

/// Valid recolourings of one port mask, best first.
class Candidates {
 public:
  /// `colorings` are the legal colourings of the side after the operation.
  Candidates(const Operation& operation, const std::vector<Coloring>& colorings, Mask ports);

  /// The best recolouring that joins only previously joined pairs; null if no such recolouring exists. Fans always have
  /// one: everything dashed inside, and no port given up.
  [[nodiscard]] const Choice* best(const PortPairs& joined_before) const;

  /// The list of linked rules: the recolourings that are not covered, best first. A recolouring is covered if a better
  /// one joins only pairs that it joins too. For each set of pairs joined outside, the first recolouring that closes no
  /// cycle with it is best.
  [[nodiscard]] std::vector<std::pair<Choice, PortPairs>> uncovered() const;

 private:
  struct Candidate {
    Choice choice;
    PortPairs joins;
    CriterionValues values{};
  };
  std::vector<Candidate> candidates_;
};

}  // namespace restrip::generator
