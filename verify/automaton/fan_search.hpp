#pragma once
// The best sound recolouring of a fan for every key, by plain search: every colouring is tried, and every strip walked.

#include <optional>
#include <utility>
#include <vector>

#include "automaton/answers.hpp"

namespace restrip::verify {

/// A colouring of the inner edges of a patch without ports: degrees at most two and no cycle.
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

  /// A recolouring that is sound for some key with certain ports.
  struct Sound {
    Mask inner = 0;
    Mask joins = 0;  ///< the key's bits for its joins
    int cost = 0;    ///< minus the restarts of all triangles
  };
  std::vector<Sound> colorings(Mask ports) const;

  /// The possible bits of `joined`: solid ports with a predecessor.
  Mask joinable(Mask ports) const;
  /// If each of two ports precedes the other, a key has both bits or none.
  bool two_in_ring(Mask ports) const { return place_.closed() && solid_count(ports) == 2; }
  Mask end_of_inner() const { return mask_count(static_cast<unsigned>(inner_.size())); }

 private:
  struct Inner {
    std::size_t one;
    std::size_t other;
  };
  std::optional<InnerColoring> survey_inner(Mask inner) const;
  std::optional<Sound> with_ports(const InnerColoring& coloring, Mask ports) const;
  std::optional<unsigned> port_before(unsigned port, Mask ports) const;

  FanPlace place_;
  std::vector<std::optional<unsigned>> port_of_;  ///< of each triangle, in the order of docs/reference/notation.md
  std::vector<Inner> inner_;
  std::vector<InnerColoring> legal_;
};

}  // namespace restrip::verify
