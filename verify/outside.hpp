#pragma once
// What may lie outside a patch: strips that join its ports in pairs. A patch together with such strips is one graph, in
// which cycles are looked for as such.

#include <array>
#include <vector>

#include "patch.hpp"

namespace restrip::verify {

/// All sets of pairs of these ports in which no port is twice; the empty one first.
std::vector<PortPairs> matchings_of(Mask ports);

/// A patch, its solid ports, and the strips outside that join some of them, each as one edge between outside nodes.
class World {
 public:
  World(const Patch& patch, Mask ports, PortPairs outside);

  struct View {
    bool sound = false;  ///< degrees at most two, no cycle
    int isolated = 0;    ///< triangles without a solid edge
  };
  /// What the colours of the inner edges amount to in this world. Linear in the patch.
  View look(Mask inner) const;

 private:
  struct Ends {
    Node one;
    Node other;
  };
  // A patch has at most 8 + 2 triangles and 8 outside nodes.
  static constexpr std::size_t most_nodes = 24;

  std::vector<Node> triangles_;
  std::vector<Ends> always_;  ///< solid ports, strips outside
  std::vector<Ends> inner_;   ///< by index
};

/// Whether two pairings close a cycle when they are laid together: found by following them in turn, without a graph.
bool close_a_cycle(PortPairs one, PortPairs other, unsigned ports);

}  // namespace restrip::verify
