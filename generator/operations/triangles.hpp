// A patch given by its triangles: docs/reference/operation-file.md, "Triangles", and "Families" where vertices have
// indices. Inner edges, ports and their order follow.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "operations/formula.hpp"
#include "operations/operation.hpp"

namespace restrip::generator {

/// What stands in the file of a single operation.
struct NamedPatch {
  using Triangles = std::vector<std::array<std::string, 3>>;
  Triangles before;
  Triangles after;
  std::vector<std::array<std::string, 2>> boundary;
};

/// One triangle, or one for each value of an index.
struct TrianglePattern {
  std::array<IndexedName, 3> corners;
  std::optional<Stretch> index;  ///< its name and values
};

/// A side for all positions.
using TrianglePatterns = std::vector<TrianglePattern>;

/// A stretch of the rim, from a vertex to a vertex.
using StretchPattern = std::array<IndexedName, 2>;

/// The triangles at one position, as the file of a single operation would name them: u[3] is u_3. Of too many a side
/// has one more than it can have. Throws std::runtime_error when an index is negative.
[[nodiscard]] NamedPatch named_at(const TrianglePatterns& before, const TrianglePatterns& after,
                                  const std::vector<StretchPattern>& boundary, const PositionNumbers& place);

/// A triangle as one meets it from the first: every other one across a side of one before it, which is its own side 0.
struct SurfaceTriangle {
  unsigned from = 0;                   ///< the triangle that it is entered from, by its place in the list
  unsigned from_side = 0;              ///< and over which side of that
  std::array<unsigned, 3> vertex{};    ///< its corners; side s runs from corner s to the next one
  std::array<std::uint8_t, 3> side{};  ///< an inner edge, port_side and a port, or boundary_side
  static constexpr std::uint8_t port_side = 64;
  static constexpr std::uint8_t boundary_side = 255;
};

/// What a header says of the triangles, for those who change a mesh; empty for patches that are graphs only.
struct Surface {
  std::vector<SurfaceTriangle> before;
  std::vector<SurfaceTriangle> after;
  unsigned vertices = 0;  ///< of both sides, numbered in the order in which the file names them
};

struct SurfacePatch {
  Patch patch;
  Surface surface;
};

/// What is wrong, and where: member "before", "after" or "boundary", and which of its elements if it is one.
struct PatchFault : std::runtime_error {
  PatchFault(std::string in_member, int in_element, const std::string& what)
      : std::runtime_error(what), member(std::move(in_member)), element(in_element) {}
  std::string member;
  int element;  ///< -1: none of them
};

/// Throws PatchFault when the triangles are no discs with the same rim.
[[nodiscard]] SurfacePatch surface_patch(const NamedPatch& named);

}  // namespace restrip::generator
