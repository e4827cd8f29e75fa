// From a mesh to its levels of detail: edges are collapsed, the cheapest first, and each collapse is recorded.
//
//   Simplifier simplifier(StripMesh::build(triangles, points.size()), points);
//   if (!simplifier.run(1000)) report(simplifier.obstacles());  // stopped short: no further edge may collapse
//   const StripMesh& coarse = simplifier.mesh();                // spokes_of(coarse, simplifier.collapses().back()),
//   ...
//
// An edge collapses into one of its ends (a half-edge collapse), so no vertex ever moves and a record is four vertices.
// The cost is the quadric error (Garland and Heckbert, "Surface simplification using quadric error metrics", 1997) of
// the vertex that is removed, at the place of the vertex that stays: the squared distance to the planes of all
// triangles that it stands for, weighted by their areas. Boundary edges add planes that are perpendicular to their
// triangle. The error is divided by the fourth root of the area, so that large flat regions are not spared for small
// features. Where the surface is flat all errors are zero; there the shorter edge and the better shaped triangles win.
//
// Guarantees. A collapse is granted only if
//  - check_collapse() grants it (link condition);
//  - no remaining triangle turns by 90 degrees or more, against itself before the collapse and against itself in the
//    original mesh, or loses its area;
//  - a boundary vertex stays on the boundary: it moves along a boundary edge, or not at all (BoundaryPolicy);
//  - a component that is a height field stays one: if all its triangles face along an axis, or along the sum of their
//    normals, no triangle ever faces the other way.
// Collapses that turn a triangle by more than 60 degrees wait until no other is left, then corners of the outline.
//
// The same input gives the same collapses on every machine, as long as it is compiled with -ffp-contract=off,
// as our CMake targets are, and without -ffast-math: all arithmetic is IEEE additions, multiplications, divisions and
// square roots, and ties are broken by the numbers of vertices. Compilers for ARM and others otherwise fuse
// multiplications and additions, which may change the choice between collapses of almost the same cost.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "restrip/mesh/split_record.hpp"
#include "restrip/mesh/strip_mesh.hpp"

namespace restrip::tools {

namespace simplifying {
class Engine;  // simplifier.cpp
}

enum class BoundaryPolicy : std::uint8_t {
  lock,  ///< only edges between two interior vertices collapse: every split divides a closed fan
  move   ///< boundary vertices move along the boundary
};

/// How many edges of a mesh cannot collapse, and why.
struct Obstacle {
  const char* why = nullptr;  ///< one human-readable sentence
  std::size_t edges = 0;
};

class Simplifier {
 public:
  using Point = std::array<double, 3>;

  /// A vertex with more neighbours is neither collapsed nor collapsed into, because each such operation would turn
  /// around it. Its neighbours collapse into each other instead, which removes a triangle of it each time. Once it has
  /// few enough neighbours, it takes part.
  static constexpr std::size_t most_neighbors = 256;

  /// Time O(n log n). `points` has one for each vertex of the mesh; coordinates may be of any size, also in the details
  /// of a mesh (the shape of a triangle counts, not its size). Vertices whose coordinates are not finite stay, and so
  /// do the vertices in `fixed`: others may collapse into them. About 250 bytes a vertex and 100 a triangle.
  Simplifier(StripMesh mesh, std::span<const Point> points, BoundaryPolicy boundary = BoundaryPolicy::move,
             std::span<const Vertex> fixed = {});
  ~Simplifier();
  Simplifier(Simplifier&& other) noexcept;
  Simplifier& operator=(Simplifier&& other) noexcept;

  /// Collapses edges until at most `wanted` triangles are left, no further edge may collapse, or `most` collapses are
  /// done. Returns whether it is finished: call it again until then, between reports of progress. A few microseconds a
  /// collapse, O(n log n) for all of them, whatever the valences. May throw std::bad_alloc; then only destroy it.
  bool run(std::size_t wanted, std::size_t most = (std::numeric_limits<std::size_t>::max)());

  /// The mesh as it is now. Non-manifold vertices, and what check_collapse() refuses, are unchanged.
  [[nodiscard]] const StripMesh& mesh() const noexcept;
  /// From fine to coarse: read backward, the splits from mesh() to the original mesh.
  [[nodiscard]] const std::vector<SplitRecord>& collapses() const noexcept;
  /// After run() has stopped short: for each remaining edge, why it may not collapse; the most frequent reason first.
  [[nodiscard]] std::vector<Obstacle> obstacles();
  /// The number of vertices with more than most_neighbors neighbours.
  [[nodiscard]] std::size_t large_vertices() const noexcept;

 private:
  std::unique_ptr<simplifying::Engine> engine_;
};

}  // namespace restrip::tools
