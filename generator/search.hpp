// Exhaustive search: the best sound recolouring for every key.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "operation.hpp"

namespace restrip::generator {

/// A set of pairs of ports, at most sixteen ports: bit j (j - 1) / 2 + i stands for {i, j}, i < j.
struct PortPairs {
  std::array<std::uint64_t, 2> words{};

  void add(unsigned low, unsigned high);
  [[nodiscard]] bool within(const PortPairs& others) const {
    return ((words[0] & ~others.words[0]) | (words[1] & ~others.words[1])) == 0;
  }
};

/// The same of masks with two bits each.
[[nodiscard]] PortPairs port_pairs(const std::vector<Mask>& pairs);

/// The colours after an operation.
struct Choice {
  Mask recoloring = 0;
  Mask kept = 0;          ///< ports that stay solid
  unsigned solid = 0;     ///< solid inner edges
  unsigned isolated = 0;  ///< isolated triangles; a port given up counts as one
};

/// Valid recolourings of one port mask, best first.
class Candidates {
 public:
  /// `colorings` are the legal ones of the side after the operation.
  Candidates(const Operation& operation, const std::vector<Coloring>& colorings, Mask ports);

  /// The best recolouring that joins no pair of ports but these, which were joined before; null when there is none. For
  /// fans there always is one: everything dashed inside, and nothing given up.
  [[nodiscard]] const Choice* best(const PortPairs& joined_before) const;

 private:
  struct Candidate {
    Choice choice;
    PortPairs joins;
    CriterionValues values{};
  };
  std::vector<Candidate> candidates_;
};

}  // namespace restrip::generator
