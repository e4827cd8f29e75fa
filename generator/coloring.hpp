// Colorings of one side of a patch, as bit masks: which are legal inside, and what they join.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "patch.hpp"

namespace restrip::generator {

/// Colours of up to 32 dual edges, 1 = solid.
using Mask = std::uint32_t;

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

/// A legal coloring together with the colours of the ports.
struct Outcome {
  unsigned solid = 0;       ///< solid inner edges
  unsigned isolated = 0;    ///< isolated triangles
  std::vector<Mask> pairs;  ///< joined ports, two bits each
};

/// Nothing when the ports make some degree exceed two.
[[nodiscard]] std::optional<Outcome> with_ports(const Coloring& coloring, Mask ports);

/// The key's second mask (docs/notation.md): bit i is set when solid port i is paired with the solid port that precedes
/// it. `leftover`, if given, is set when some pair is not of consecutive solid ports.
[[nodiscard]] Mask joined_to_previous(const std::vector<Mask>& pairs, Mask ports, unsigned k, bool closed,
                                      bool* leftover = nullptr);

}  // namespace restrip::generator
