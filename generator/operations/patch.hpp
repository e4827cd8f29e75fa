// A patch: the triangles that one operation touches, before and after it. Search and symmetries know nothing else of an
// operation but what is preferred (operation.hpp).
#pragma once

#include <cstdint>
#include <vector>

namespace restrip::generator {

/// Colours of up to 32 dual edges, 1 = solid; or a set of edges, triangles or ports.
using Mask = std::uint32_t;

/// A dual edge inside the patch, by its two nodes.
struct Edge {
  unsigned u = 0;
  unsigned v = 0;
  friend bool operator==(const Edge&, const Edge&) = default;
};

/// The patch at one moment: nodes 0 … nodes - 1, inner edges in the order of their mask bits, and for each port its
/// node.
struct Side {
  unsigned nodes = 0;
  std::vector<Edge> edges;
  std::vector<unsigned> owner;

  [[nodiscard]] unsigned ports() const { return static_cast<unsigned>(owner.size()); }
  [[nodiscard]] Mask all_ports() const { return (Mask{1} << owner.size()) - 1; }
  friend bool operator==(const Side&, const Side&) = default;
};

/// What the solid edges must be: no cycle, and at most so many at a triangle. Two make strips, one a matching, three a
/// forest.
struct Constraint {
  unsigned most_edges = 2;
  friend bool operator==(const Constraint&, const Constraint&) = default;
};

/// Before and after share the ports; nothing else need correspond.
struct Patch {
  Side before;
  Side after;
};

}  // namespace restrip::generator
