#pragma once
// The best sound recolouring of a fan for every key, by plain search: triangles with their corners, every colouring
// tried, every strip walked, every swap found by the corners about which strips pass.

#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "automaton/answers.hpp"

namespace restrip::verify {

/// A corner of a triangle: the two ends of the new mesh edge, one of which is the hub where none exists, and the
/// corners of the rim.
using CornerNumber = int;
inline constexpr CornerNumber no_corner = -1;
using MeshEdge = std::array<CornerNumber, 2>;

/// A colouring of the inner edges of a patch: degrees at most two and no cycle, ports left out.
struct InnerColoring {
  Mask inner = 0;
  Mask full = 0;                                      ///< ports of triangles with two solid inner edges
  Mask lonely = 0;                                    ///< ports of triangles with none
  int isolated = 0;                                   ///< triangles without a port and without a solid edge
  std::vector<std::pair<unsigned, unsigned>> joined;  ///< ports that a strip joins if they are solid
  std::vector<CornerNumber> passed;  ///< about which corner each triangle is passed, as far as its port is not needed
  std::vector<CornerNumber> passed_to_port;  ///< the same if its port is solid
};

class FanSearch {
 public:
  FanSearch(const FanPlace& place, const Weights& weights);

  /// A recolouring that is sound for some key with certain ports.
  struct Sound {
    Mask inner = 0;
    Mask joins = 0;                          ///< the key's bits of what it joins
    int cost = 0;                            ///< but for swaps at ports; less the restarts of all triangles
    std::vector<CornerNumber> port_corners;  ///< about which strips pass the triangles of solid ports
  };
  std::vector<Sound> colorings(Mask ports) const;

  /// What lies behind the ports, as corners.
  std::vector<CornerNumber> behind(const FanKey& key) const;
  int cost(const Sound& coloring, const std::vector<CornerNumber>& behind) const;

  /// The bits that `joined` may have: solid ports that have a predecessor.
  Mask joinable(Mask ports) const;
  /// Where each of two ports precedes the other, a key has both bits or none.
  bool two_in_ring(Mask ports) const { return place_.closed() && solid_count(ports) == 2; }
  Mask end_of_inner() const { return mask_count(static_cast<unsigned>(inner_.size())); }

 private:
  struct Inner {
    std::size_t one;
    std::size_t other;
    MeshEdge crossed;
  };
  void add_inner(std::size_t one, std::size_t other);
  std::optional<InnerColoring> survey_inner(Mask inner) const;
  std::optional<Sound> with_ports(const InnerColoring& coloring, Mask ports) const;
  std::optional<unsigned> port_before(unsigned port, Mask ports) const;

  FanPlace place_;
  Weights weights_;
  std::vector<std::array<CornerNumber, 3>> triangles_;  ///< in the order of docs/reference/notation.md
  std::vector<std::optional<unsigned>> port_of_;        ///< of each triangle
  std::vector<MeshEdge> ports_;
  std::vector<Inner> inner_;
  std::vector<InnerColoring> legal_;
};

}  // namespace restrip::verify
