#pragma once
// The colours of one side of an operation: degrees, cycles, joined ports, and a line of text.

#include <optional>
#include <string>

#include "model/operation.hpp"
#include "model/solid_graph.hpp"

namespace restrip::verify {

/// The solid inner edges; nullopt when they close a cycle.
std::optional<SolidGraph> inner_graph(const Side& side, Mask inner);

using Degrees = std::array<unsigned, most_triangles>;
/// How many solid edges each triangle has, ports counted.
Degrees degrees(const Side& side, Colors colors);

/// The pairs of solid ports whose triangles are connected by solid inner edges.
PortPairs joined_ports(const Side& side, const SolidGraph& inner, Mask ports);

/// Triangles without a solid edge, ports counted.
unsigned isolated_of(const Side& side, Colors colors);

/// The number of strips that a side counts: its triangles minus its solid edges, ports included.
int strips_of(const Side& side, Colors colors);

/// What colours amount to where solid edges are strips.
struct Survey {
  bool valid = false;  ///< degrees at most two, no cycle; the rest means something only then
  unsigned isolated = 0;
  PortPairs joined;
};
Survey survey(const Side& side, Colors colors);

/// The name of a triangle as the description has it.
std::string name_of(const Side& side, unsigned triangle);

/// Why the colours are not valid: "triangle 2 has 3 solid edges"; empty when they are.
std::string invalid_because(const Side& side, Colors colors, unsigned most_solid);

/// "edges 0=1 1-2, ports 0" 1:", with = and " for solid, - and : for dashed.
std::string drawn(const Side& side, Colors colors);

/// "0-1 2-3", or "none".
std::string listed(PortPairs pairs, unsigned ports);

}  // namespace restrip::verify
