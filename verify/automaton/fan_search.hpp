#pragma once
// The best sound recolouring of a fan for every key, by plain search: every colouring of the explicit graph, every
// strip walked. For fans larger than those of the tables.

#include <utility>
#include <vector>

#include "answers.hpp"

namespace restrip::verify {

/// A colouring of the inner edges of a patch: degrees at most two and no cycle, ports left out.
struct InnerColoring {
  Mask inner = 0;
  Mask full = 0;                                      ///< ports of triangles with two solid inner edges
  Mask lonely = 0;                                    ///< ports of triangles with none
  int isolated = 0;                                   ///< triangles without a port and without a solid edge
  std::vector<std::pair<unsigned, unsigned>> joined;  ///< ports that a strip joins if they are solid
};

class FanSearch {
 public:
  explicit FanSearch(const FanPlace& place);

  /// All keys with these solid ports. The pair that a bit of `joined` stands for is that of docs/notation.md.
  class Keys {
   public:
    /// The most that any sound recolouring is worth.
    Worth best(Mask joined) const { return best_[normal(joined)]; }
    /// What a recolouring is worth that is sound for the key; nullopt when it is not.
    std::optional<Worth> worth_if_sound(Mask inner, Mask joined) const;

   private:
    friend class FanSearch;
    Mask normal(Mask joined) const;

    const FanSearch* search_ = nullptr;
    Mask ports_ = 0;
    std::vector<Worth> best_;  ///< by joined mask
  };
  Keys keys(Mask ports) const;

  /// The bits that `joined` may have: solid ports that have a predecessor.
  Mask joinable(Mask ports) const;
  std::size_t colorings() const { return colorings_.size(); }

 private:
  bool two_in_ring(Mask ports) const { return place_.closed() && solid_count(ports) == 2; }
  /// What the coloring is worth with these ports, and the key's bits of what it joins; nullopt when it is not sound for
  /// any key.
  std::optional<std::pair<Worth, Mask>> outcome(const InnerColoring& coloring, Mask ports) const;
  std::optional<unsigned> predecessor(unsigned port, Mask ports) const;

  FanPlace place_;
  std::vector<InnerColoring> colorings_;
  std::vector<int> place_of_inner_;  ///< in colorings_; -1 for colourings that are not legal
};

}  // namespace restrip::verify
