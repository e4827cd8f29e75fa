#pragma once
// A patch that its file gives by triangles with named vertices (docs/reference/operation-file.md, "Triangles"): whether
// it is an operation on a mesh, and the dual graphs of its two sides.

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

/// The dual graph of a disc of triangles: inner edges by their triangles, ports by their owners, both in their order.
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

/// Where something is not as the document says: an element of the member "before", "after" or "boundary", or all of it.
struct SurfaceFault {
  std::string member;
  std::optional<std::size_t> element;
  std::string what;  ///< "expected …, found …"
};

/// Throws SurfaceFault unless both sides are discs of triangles that have the same rim but for what lies on the
/// boundary of the mesh. How many triangles, edges and ports there may be is for the caller to say.
SurfaceGraphs graphs_of(const NamedSurface& surface);

}  // namespace restrip::verify
