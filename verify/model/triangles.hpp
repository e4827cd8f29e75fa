#pragma once
// A patch given by triangles with named vertices (docs/reference/operation-file.md, "Triangles"): checks that it is an
// operation on a mesh, and computes the dual graphs of its two sides.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "model/side.hpp"

namespace restrip::verify {

using NamedTriangles = std::vector<std::array<std::string, 3>>;

struct NamedSurface {
  NamedTriangles before;
  NamedTriangles after;
  std::vector<std::array<std::string, 2>> boundary;
};

/// The dual graph of a disc of triangles: inner edges by their triangles and ports by their owners, both in order.
struct PatchGraph {
  unsigned triangles = 0;
  std::vector<std::array<unsigned, 2>> edges;
  std::vector<unsigned> owner_of_port;
  std::vector<PlacedTriangle> placed;
};

struct SurfaceGraphs {
  PatchGraph before;
  PatchGraph after;
};

/// The place of a fault: an element of the member "before", "after" or "boundary", or the whole member.
struct SurfaceFault {
  std::string member;
  std::optional<std::size_t> element;
  std::string what;  ///< "expected …, found …"
};

/// Throws SurfaceFault unless both sides are discs of triangles with the same outline, apart from edges on the boundary
/// of the mesh. The caller checks the limits on triangles, edges and ports.
SurfaceGraphs graphs_of(const NamedSurface& surface);

}  // namespace restrip::verify
