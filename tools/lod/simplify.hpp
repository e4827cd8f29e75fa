// Simplifies a soup to a progressive mesh with the simplifier (lod/simplifier.hpp).
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "lod/progressive_mesh.hpp"
#include "lod/simplifier.hpp"
#include "meshes/soup.hpp"

namespace restrip::tools {

struct SimplifyOptions {
  double base = 0.02;  ///< the wanted share of triangles, 0 < base <= 1
  BoundaryPolicy boundary = BoundaryPolicy::move;
  std::size_t triangles = 0;  ///< the wanted number, instead of the share; 0: use the share
};

/// Parts of the mesh that no operation touches.
struct LeftOut {
  std::size_t degenerate_triangles = 0;   ///< not part of the mesh
  std::size_t non_manifold_vertices = 0;  ///< vertices at which the soup is not manifold
  std::size_t large_vertices = 0;         ///< vertices of the base with more than Simplifier::most_neighbors neighbours
  std::size_t seam_vertices = 0;          ///< vertices that stay, because attributes differ there
  std::size_t back_to_back = 0;           ///< triangles of the base on the same corners as one of the other orientation
  /// Why the edges of the base cannot collapse, the most frequent reason first. Empty if the base is as coarse as
  /// wanted.
  std::vector<Obstacle> obstacles = {};
};

/// Explains to the user why the base has more triangles than wanted, and names a remedy if one is known.
[[nodiscard]] std::string why_no_coarser(const LeftOut& left_out);

struct Simplification {
  ProgressiveMesh mesh;
  std::size_t wanted_triangles = 0;  ///< mesh.base has more if no edge of it may collapse: why_no_coarser()
  LeftOut left_out;
  [[nodiscard]] bool stopped_short() const noexcept { return mesh.base.size() > wanted_triangles; }
};

/// The splits lead back to exactly the soup's triangles. If the soup has attributes, vertices on seams stay; otherwise
/// close the seams first, or their two sides move apart.
[[nodiscard]] Simplification simplify(const Soup& soup, const SimplifyOptions& options = {});

}  // namespace restrip::tools
