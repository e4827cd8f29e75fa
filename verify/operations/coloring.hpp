#pragma once
// The colours of one side of an operation: degrees, cycles, joined ports, and a line of text.

#include <optional>
#include <string>
#include <vector>

#include "solid_graph.hpp"

namespace restrip::verify::operations {

/// Solid inner edges and solid ports; after the operation the ports are those that stay solid.
struct Colors {
  Mask inner = 0;
  Mask ports = 0;
  friend constexpr bool operator==(Colors, Colors) = default;
};

/// The solid inner edges; nullopt when they close a cycle.
std::optional<SolidGraph> inner_graph(const Side& side, Mask inner);

/// How many solid edges each triangle has, ports counted.
std::array<unsigned, most_triangles> degrees(const Side& side, Colors colors);

/// The pairs of solid ports whose triangles are connected by solid inner edges.
PortPairs joined_ports(const Side& side, const SolidGraph& inner, Mask ports);

/// Why the colours are not valid: "triangle 2 has 3 solid edges"; empty when they are.
std::string invalid_because(const Side& side, Colors colors, unsigned most_solid);

/// "edges 0=1 1-2, ports 0" 1:", with = and " for solid, - and : for dashed.
std::string drawn(const Side& side, Colors colors);

}  // namespace restrip::verify::operations
