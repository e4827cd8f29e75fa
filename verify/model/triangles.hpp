// A patch given by triangles with named vertices (docs/reference/operation-file.md, "Triangles"): checks that it is an
// operation on a mesh, and computes the dual graphs of its two sides.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "model/operation.hpp"

namespace restrip::verify {

using NamedTriangles = std::vector<std::array<std::string, 3>>;

struct NamedSurface {
  NamedTriangles before;
  NamedTriangles after;
  std::vector<std::array<std::string, 2>> boundary;
};

/// The two sides of an operation.
struct Sides {
  Side before;
  Side after;
  unsigned vertices = 0;  ///< 0 for fans
  std::vector<PlacedTriangle> placed_before;
  std::vector<PlacedTriangle> placed_after;
};

/// The place of a fault: an element of the member "before", "after" or "boundary", or the whole member.
struct SurfaceFault {
  std::string member;
  std::optional<std::size_t> element;
  std::string what;  ///< "expected …, found …"
};

/// The dual graphs: inner edges by their triangles and ports by their owners, both in order, and what lies around each
/// triangle.
/// Throws SurfaceFault unless both sides are discs of triangles with the same outline, apart from edges on the boundary
/// of the mesh. The caller checks the limits on triangles, edges and ports.
Sides graphs_of(const NamedSurface& surface);

}  // namespace restrip::verify
