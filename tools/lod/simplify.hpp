// Simplifies a soup to a progressive mesh. OpenMesh's decimater and its quadric error (Garland and Heckbert 1997)
// choose the cheapest edge; StripMesh decides which edges may be collapsed.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "lod/progressive_mesh.hpp"
#include "meshes/soup.hpp"

namespace restrip::tools {

enum class BoundaryPolicy {
  lock,  ///< only edges between two interior vertices collapse: every split divides a closed fan
  move   ///< boundary vertices may collapse
};

struct SimplifyOptions {
  double base = 0.02;  ///< the wanted share of triangles, 0 < base <= 1
  BoundaryPolicy boundary = BoundaryPolicy::move;
  std::size_t triangles = 0;  ///< the wanted number, instead of the share; 0: use the share
};

/// A vertex with more neighbours than this is neither collapsed nor collapsed into, because each such operation would
/// turn around it, on the way down and on every way up. Its neighbours collapse into each other instead, which removes
/// a triangle of it each time. Once it has few enough neighbours, it takes part.
inline constexpr std::size_t most_neighbors = 1024;

/// How many edges of the base cannot collapse, and why.
struct Obstacle {
  std::string why;
  std::size_t edges = 0;
};

/// Parts of the mesh that no operation touches.
struct LeftOut {
  std::size_t degenerate_triangles = 0;   ///< not part of the mesh
  std::size_t non_manifold_vertices = 0;  ///< vertices at which the soup is not manifold
  std::size_t frozen_vertices = 0;  ///< regular, but adjacent to a triangle that OpenMesh cannot hold: collapsed last
  std::size_t large_vertices = 0;   ///< vertices of the base with more than most_neighbors neighbours
  /// Why the edges of the base cannot collapse, the most frequent reason first. Empty if the base is as coarse as
  /// wanted.
  std::vector<Obstacle> obstacles = {};
};

/// Explains to the user why the base has more triangles than wanted.
[[nodiscard]] std::string why_no_coarser(const LeftOut& left_out);

struct Simplification {
  ProgressiveMesh mesh;
  std::size_t wanted_triangles = 0;  ///< mesh.base has more if no edge of it may collapse: why_no_coarser()
  LeftOut left_out;
  [[nodiscard]] bool stopped_short() const noexcept { return mesh.base.size() > wanted_triangles; }
};

/// The splits lead back to exactly the soup's triangles. About 10 microseconds a collapse and 300 bytes a triangle. O(n
/// log n) for n triangles, whatever the valences. Deterministic.
[[nodiscard]] Simplification simplify(const Soup& soup, const SimplifyOptions& options = {});

}  // namespace restrip::tools
