// From a soup to a progressive mesh: OpenMesh's decimater and its quadric error (Garland and Heckbert 1997) choose the
// cheapest edge, StripMesh says which edges may be collapsed at all.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "lod/progressive_mesh.hpp"
#include "meshes/soup.hpp"

namespace restrip::tools {

enum class BoundaryPolicy {
  lock,  ///< only edges between two interior vertices collapse: every split divides a closed fan
  move   ///< boundary vertices take part
};

struct SimplifyOptions {
  double base = 0.02;  ///< the wanted share of triangles, 0 < base <= 1
  BoundaryPolicy boundary = BoundaryPolicy::move;
  std::size_t triangles = 0;  ///< wanted instead of the share; 0: the share
};

/// A vertex with more neighbours than this is neither collapsed nor collapsed into: each such operation would turn
/// around it, on the way down and on every way up. Its neighbours collapse into each other instead, which costs it a
/// triangle each time and nothing else; once it has few enough, it takes part.
inline constexpr std::size_t most_neighbors = 1024;

/// Why so many edges of the base cannot collapse.
struct Obstacle {
  std::string why;
  std::size_t edges = 0;
};

/// What no operation touches.
struct LeftOut {
  std::size_t degenerate_triangles = 0;   ///< they are in no mesh at all
  std::size_t non_manifold_vertices = 0;  ///< where the soup is not manifold
  std::size_t frozen_vertices = 0;        ///< regular, but beside a triangle that OpenMesh cannot hold: touched last
  std::size_t large_vertices = 0;         ///< of the base: those with more than most_neighbors neighbours
  /// For each edge of the base why it cannot collapse, most edges first. Empty where the base is as coarse as wanted.
  std::vector<Obstacle> obstacles = {};
};

/// Why the base has more triangles than were wanted, for a reader.
[[nodiscard]] std::string why_no_coarser(const LeftOut& left_out);

struct Simplification {
  ProgressiveMesh mesh;
  std::size_t wanted_triangles = 0;  ///< mesh.base has more where no edge of it may collapse: why_no_coarser()
  LeftOut left_out;
  [[nodiscard]] bool stopped_short() const noexcept { return mesh.base.size() > wanted_triangles; }
  std::size_t steps = 0;  ///< edges considered, and spokes that were walked over to judge them
};

/// Never changes the soup's surface on its way: the splits lead back to exactly its triangles. About 10 microseconds a
/// collapse, 300 bytes a triangle while it runs. O(n log n) for n triangles, whatever the valences. Deterministic.
[[nodiscard]] Simplification simplify(const Soup& soup, const SimplifyOptions& options = {});

}  // namespace restrip::tools
