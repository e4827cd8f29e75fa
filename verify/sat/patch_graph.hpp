#pragma once
// The patches of docs/notation.md as lists of nodes and edges, written down once more for the encoder alone: it must
// not inherit a mistake of the verifier's patches.

#include <string>
#include <vector>

namespace restrip::verify::sat {

struct PatchEdge {
  unsigned one = 0;
  unsigned other = 0;
};

struct PatchGraph {
  unsigned nodes = 0;
  std::vector<PatchEdge> edges;  ///< inner edges in the order of their bits
  std::vector<unsigned> owner;   ///< the node of each port
  std::vector<bool> inserted;    ///< by node: A or D
  bool has_chord = false;        ///< the last edge
};

/// An operation at one position: what it starts from, what it leaves.
struct Position {
  PatchGraph before;
  PatchGraph after;
  bool gives_ports_up = false;  ///< the flip
};

/// Of a family and a position as docs/notation.md and certificates name them, such as "open-split", "k 5 gaps 1 3".
/// InputError when there is no such family.
Position position_of(const std::string& family, const std::string& position);

}  // namespace restrip::verify::sat
