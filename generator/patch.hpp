// A patch: the triangles that one operation touches, before and after it. Every family is a description of this form
// (docs/notation.md); enumeration, search and emission know nothing else about an operation.
#pragma once

#include <compare>
#include <string>
#include <vector>

namespace restrip::generator {

/// A dual edge inside the patch, by its two nodes.
struct Edge {
  unsigned u = 0;
  unsigned v = 0;
};

/// The patch at one moment: nodes 0 … nodes - 1, inner edges in the order of their mask bits, and for each port its
/// node.
struct Side {
  unsigned nodes = 0;
  std::vector<Edge> edges;
  std::vector<unsigned> owner;
};

/// What the solid edges must be: no cycle, and at most so many at a triangle. Two make strips, one a matching, three a
/// forest.
struct Constraint {
  unsigned most_edges = 2;
};

/// Before and after share the ports; nothing else need correspond.
struct Patch {
  Side before;
  Side after;
};

enum class Family { split, collapse, open_split, open_collapse, boundary_split, boundary_collapse, flip };

/// Where an operation happens: `k` triangles in the fan; `at` is the arc a of a split, or gap i; `to` is gap j of an
/// open-split. Unused members are 0.
struct Position {
  Family family = Family::split;
  unsigned k = 0;
  unsigned at = 0;
  unsigned to = 0;
  friend auto operator<=>(const Position&, const Position&) = default;
};

/// Name of a family as certificates spell it.
[[nodiscard]] std::string name_of(Family family);

/// All positions of a family with this valence, one for each class under mirror images and half turns, in ascending
/// order.
[[nodiscard]] std::vector<Position> positions(Family family, unsigned k);

/// The smallest valence of a family.
[[nodiscard]] unsigned smallest_valence(Family family);

/// True when the fan closes around an interior vertex.
[[nodiscard]] bool closed(Family family);

/// True when the operation removes triangles, so that its rules do not depend on the position.
[[nodiscard]] bool collapses(Family family);

[[nodiscard]] Patch make_patch(const Position& position);

/// The bare fan, before and after: what the rules of a collapse act on, wherever the removed triangles were.
[[nodiscard]] Patch make_fan_patch(unsigned k, bool closed);

}  // namespace restrip::generator
