// A patch: the triangles that one operation touches, before and after it. Every family is a description of this form
// (family.hpp); enumeration, search and emission know nothing else about an operation.
#pragma once

#include <compare>
#include <vector>

#include "family.hpp"

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

/// Where an operation of a family happens: `k` triangles in the fan; `at` is the arc a of a split, or gap i; `to` is
/// gap j of an open-split. Unused members are 0; k is the number of ports where the family has only one position.
struct Position {
  const Family* family = nullptr;
  unsigned k = 0;
  unsigned at = 0;
  unsigned to = 0;
  [[nodiscard]] PositionNumbers numbers() const { return {k, at, to}; }
  friend auto operator<=>(const Position&, const Position&) = default;
};

/// All positions of a family with this valence, one for each class under mirror images and half turns, in ascending
/// order.
[[nodiscard]] std::vector<Position> positions(const Family& family, unsigned k);

/// The smallest valence of a family.
[[nodiscard]] unsigned smallest_valence(const Family& family);

/// True when the fan closes around an interior vertex.
[[nodiscard]] bool closed(const Family& family);

/// True when a section of its certificate serves all positions of a valence: its rules do not depend on the position.
[[nodiscard]] bool serves_every_position(const Family& family);

[[nodiscard]] Patch make_patch(const Position& position);

/// What the rows of a position act on: its patch; where they serve every position, of which only k need be given then,
/// the side after alone, before and after.
[[nodiscard]] Patch patch_of_rows(const Position& position);

}  // namespace restrip::generator
