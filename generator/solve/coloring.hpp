// Colorings of one side of a patch, as bit masks: which are legal inside, and what they join.
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

/// A legal coloring of the inner edges: degrees as the constraint says, no solid cycle; with what the search needs of
/// it.
struct Coloring {
  Mask inner = 0;
  Mask full = 0;              ///< ports that must be dashed: their node has all its solid edges inside
  std::vector<Crowd> crowds;  ///< nodes that have room for a port, but not for all their ports
  std::vector<Mask> strips;   ///< for each strip, the ports of its nodes (strips without ports are left out)
  std::vector<Mask> lonely;   ///< for each node without a solid inner edge, its ports
};

/// All legal colorings of the inner edges of a side, in ascending order of their masks.
[[nodiscard]] std::vector<Coloring> legal_colorings(const Side& side, Constraint constraint = {});

/// The one with these inner edges of all legal ones; null when none exists.
[[nodiscard]] const Coloring* coloring_of(const std::vector<Coloring>& legal, Mask inner);

/// A legal coloring together with the colours of the ports.
struct Outcome {
  unsigned solid = 0;     ///< solid inner edges
  unsigned isolated = 0;  ///< isolated triangles
  PortPairs joined;
};

/// Nothing when the ports give some triangle too many solid edges.
[[nodiscard]] std::optional<Outcome> with_ports(const Coloring& coloring, Mask ports);

}  // namespace restrip::generator
