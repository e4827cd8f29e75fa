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
// The result is the same on every machine, if the compiler does not fuse multiplications and additions
// (-ffp-contract=off; compilers for x86-64 and WebAssembly do so only on request): it uses IEEE arithmetic and square
// roots alone, and ties are broken by the numbers of vertices.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "restrip/mesh/split_record.hpp"
#include "restrip/mesh/strip_mesh.hpp"

namespace restrip {

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

  /// Time O(n log n). `points` has one for each vertex of the mesh; coordinates may be of any size. Vertices whose
  /// coordinates are not finite stay. About 250 bytes a vertex and 100 a triangle.
  Simplifier(StripMesh mesh, std::span<const Point> points, BoundaryPolicy boundary = BoundaryPolicy::move);

  /// Collapses edges until at most `wanted` triangles are left, no further edge may collapse, or `most` collapses are
  /// done. Returns whether it is finished: call it again until then, between reports of progress. A few microseconds a
  /// collapse, O(n log n) for all of them, whatever the valences. May throw std::bad_alloc; then only destroy it.
  bool run(std::size_t wanted, std::size_t most = (std::numeric_limits<std::size_t>::max)());

  /// The mesh as it is now. Non-manifold vertices, and what check_collapse() refuses, are unchanged.
  [[nodiscard]] const StripMesh& mesh() const noexcept { return mesh_; }
  /// From fine to coarse: read backward, the splits from mesh() to the original mesh.
  [[nodiscard]] const std::vector<SplitRecord>& collapses() const noexcept { return collapses_; }
  /// After run() has stopped short: for each remaining edge, why it may not collapse; the most frequent reason first.
  [[nodiscard]] std::vector<Obstacle> obstacles();
  /// The number of vertices with more than most_neighbors neighbours.
  [[nodiscard]] std::size_t large_vertices() const noexcept;

 private:
  using Halfedge = StripMesh::Halfedge;

  struct Vector {
    double x = 0;
    double y = 0;
    double z = 0;
  };
  // The weighted squared distances to some planes, x'Ax + 2 b'x + c, as a function of the way x from a vertex. Being
  // relative to the vertex it loses no digits to the distance from the origin.
  struct Quadric;
  // What each vertex carries.
  struct Site;
  // A neighbour of the vertex that is being judged, and the triangle from there to the next neighbour.
  struct Spoke;
  // The cheapest collapse of a vertex. It is out of date if the vertex has another version by now.
  struct Candidate;
  // The collapses that are granted, from the preferred ones to all.
  enum class Stage : std::uint8_t { careful, any_turn, corners };
  static constexpr std::array stages{Stage::careful, Stage::any_turn, Stage::corners};

  void place(std::span<const Point> points);
  void find_normals();
  void find_directions();
  void add_planes();
  void find_corners();
  [[nodiscard]] Vector direction_of(Triangle t) const;
  void begin(Stage stage);
  void propose(Vertex v, const Candidate* after = nullptr);
  void gather(Vertex v);
  [[nodiscard]] double cost_of(const Quadric& quadric, std::size_t to) const;
  [[nodiscard]] bool keeps_direction(Triangle t, const Vector& before, const Vector& after, double squared) const;
  [[nodiscard]] Refusal refusal_of(Halfedge chord);
  void collapse(Halfedge chord);

  StripMesh mesh_;
  BoundaryPolicy boundary_;
  Stage stage_ = Stage::careful;
  std::vector<Site> sites_;             // by vertices
  std::vector<Vector> original_;        // normals, by triangles
  std::vector<Vector> directions_;      // that the triangles of some components face
  std::vector<std::uint32_t> faces_;    // by triangles: their component, if any has a direction
  std::vector<std::uint32_t> first_;    // by components: the first of its directions
  std::vector<Candidate> queue_;        // a heap
  std::vector<SplitRecord> collapses_;  // the finest first
  std::uint32_t mark_ = 0;
  // The fan of the vertex that is being judged.
  std::vector<Spoke> fan_;
  std::size_t fan_triangles_ = 0;
  std::vector<Vertex> around_;
};

}  // namespace restrip

#include "restrip/search/impl/simplify.hpp"
