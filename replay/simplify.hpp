// From a soup to a progressive mesh: OpenMesh's decimater and its quadric error (Garland and Heckbert 1997) choose the
// cheapest edge, StripMesh says which edges may be collapsed at all.
#pragma once

#include <cstddef>

#include "progressive_mesh.hpp"
#include "soup.hpp"

namespace restrip::replay {

enum class BoundaryPolicy {
  lock,  ///< only edges between two interior vertices collapse: every split divides a closed fan
  move   ///< boundary vertices take part
};

struct SimplifyOptions {
  double base = 0.02;  ///< the wanted share of triangles, 0 < base <= 1
  BoundaryPolicy boundary = BoundaryPolicy::move;
};

/// What no operation touches.
struct LeftOut {
  std::size_t degenerate_triangles = 0;  ///< they are in no mesh at all
  std::size_t irregular_vertices = 0;    ///< where the soup is no manifold
  std::size_t frozen_vertices = 0;       ///< regular, but beside a triangle that OpenMesh cannot hold
};

struct Simplification {
  ProgressiveMesh mesh;
  std::size_t wanted_triangles = 0;  ///< mesh.base has more when no further collapse is legal
  LeftOut left_out;
};

/// Never changes the soup's surface on its way: the splits lead back to exactly its triangles. About 10 microseconds a
/// collapse, 300 bytes a triangle while it runs. Deterministic.
[[nodiscard]] Simplification simplify(const Soup& soup, const SimplifyOptions& options = {});

}  // namespace restrip::replay
