// Exhaustive search: the best sound recolouring for every key.
#pragma once

#include <vector>

#include "section.hpp"

namespace restrip::generator {

/// Sound recolourings of one port mask, best first, in the order of preference of docs/theory.md section 4.
class Candidates {
 public:
  /// `after` is the side after the operation, `colorings` its legal colorings. A flip may give ports up.
  Candidates(const Position& position, const Side& after, const std::vector<Coloring>& colorings, Mask ports,
             Goal goal);

  /// The best recolouring that is sound for the key. There always is one: everything dashed, ports given up if they
  /// must.
  [[nodiscard]] Row best(const Key& key) const;

 private:
  struct Candidate {
    Row row;
    Mask joins = 0;  // for fans: its pairing, as the second mask of a key; for flips: a mask of pairs
    std::int64_t tie = 0;
  };
  void add(const Side& after, const Coloring& coloring, Mask ports, Mask kept);

  Position position_;
  Goal goal_;
  std::vector<Candidate> candidates_;
};

}  // namespace restrip::generator
