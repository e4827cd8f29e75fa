// The colours of one side of an operation: degrees, cycles, joined ports, and text.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "model/operation.hpp"

namespace restrip::verify {

/// The solid edges as a graph that grows edge by edge and reports when an edge closes a cycle. Its nodes are the
/// triangles of a side, followed by nodes that connect ports outside.
class SolidGraph {
 public:
  SolidGraph() {
    for (std::size_t i = 0; i < parent_.size(); ++i) parent_[i] = static_cast<std::uint8_t>(i);
  }

  /// False if the edge closes a cycle.
  bool join(unsigned one, unsigned other) {
    const unsigned a = root(one);
    const unsigned b = root(other);
    if (a == b) return false;
    parent_[a] = static_cast<std::uint8_t>(b);
    return true;
  }
  bool connected(unsigned one, unsigned other) const { return root(one) == root(other); }
  /// The node that represents the connected component of this one.
  unsigned root(unsigned node) const {
    while (parent_[node] != node) node = parent_[node];
    return node;
  }

  static constexpr unsigned outside(unsigned block) { return most_triangles + block; }

 private:
  std::array<std::uint8_t, most_triangles + most_ports> parent_{};
};

/// The solid inner edges; nullopt if they close a cycle.
std::optional<SolidGraph> inner_graph(const Side& side, Mask inner);

using Degrees = std::array<unsigned, most_triangles>;
/// The number of solid edges of each triangle, including ports.
Degrees degrees(const Side& side, Colors colors);

/// The solid inner edges of a valid colouring: no triangle has more than `most_solid` edges, including ports, and no
/// cycle is solid. nullopt if it is not valid.
std::optional<SolidGraph> valid_graph(const Side& side, Colors colors, unsigned most_solid);

/// The pairs of solid ports whose triangles are connected by solid inner edges.
PortPairs joined_ports(const Side& side, const SolidGraph& inner, Mask ports);

/// Triangles without a solid edge, including ports.
unsigned isolated_of(const Side& side, Colors colors);

/// The strips of a side: its triangles minus its solid edges, including ports.
int strips_of(const Side& side, Colors colors);

/// What an operation changes (docs/reference/notation.md, "Change").
struct Change {
  int strips = 0;
  int isolated = 0;
  friend bool operator==(Change, Change) = default;
};
Change change_of(const Operation& operation, Colors configuration, Colors after);

/// Properties of colours whose solid edges are strips.
struct Survey {
  bool valid = false;  ///< degrees at most two, no cycle; otherwise the rest has no meaning
  unsigned isolated = 0;
  PortPairs joined;
};
Survey survey(const Side& side, Colors colors);

/// The name of a triangle in the description.
std::string name_of(const Side& side, unsigned triangle);
/// "3", or with the vertices of its edge "3 (a b)".
std::string port_name(const Side& side, unsigned port);

/// Why the colours are not valid: "triangle 2 has 3 solid edges"; empty if they are.
std::string invalid_because(const Side& side, Colors colors, unsigned most_solid);

/// "edges 0=1 1-2, solid ports 0 3", with = for solid and - for dashed edges.
std::string drawn(const Side& side, Colors colors);

/// "0-1 2-3", or "none".
std::string listed(PortPairs pairs, unsigned ports);

// The cost: the criteria of an operation file, evaluated on the colours after the operation.

/// The values of the criteria in order; compared lexicographically, smaller is better. Unused ones are 0.
using CostValues = std::array<std::int64_t, most_criteria>;

/// The cost of colours after the operation, if `given_up` ports were given up.
CostValues cost_of(const Operation& operation, Colors after, unsigned given_up);

/// "strips", "isolated + given_up", "-2 solid(1,3)".
std::string text_of(const Criterion& criterion);

}  // namespace restrip::verify
