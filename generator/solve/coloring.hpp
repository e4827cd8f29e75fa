// Colorings of one side of a patch as bit masks: legal inner edges, and the ports that they join.
#pragma once

#include <optional>
#include <vector>

#include "solve/port_pairs.hpp"

namespace restrip::generator {

/// Ports of one node of which at most `room` may be solid.
struct Crowd {
  Mask ports = 0;
  int room = 0;
};

/// A legal coloring of the inner edges: degrees within the constraint, no solid cycle; with derived data for the
/// search.
struct Coloring {
  Mask inner = 0;
  Mask full = 0;              ///< ports that must be dashed: all solid edges of their node are inside
  std::vector<Crowd> crowds;  ///< nodes that have room for a port, but not for all their ports
  std::vector<Mask> strips;   ///< for each strip, the ports of its nodes; strips without ports are left out
  std::vector<Mask> lonely;   ///< for each node without a solid inner edge, its ports
};

/// All legal colorings of the inner edges of a side, in ascending order of their masks.
[[nodiscard]] std::vector<Coloring> legal_colorings(const Side& side, Constraint constraint);

/// A legal coloring together with the colours of the ports.
struct Outcome {
  unsigned solid = 0;     ///< solid inner edges
  unsigned isolated = 0;  ///< isolated triangles
  PortPairs joined;
};

/// Empty if the ports give some triangle too many solid edges.
[[nodiscard]] std::optional<Outcome> with_ports(const Coloring& coloring, Mask ports);

}  // namespace restrip::generator
