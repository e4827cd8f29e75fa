// Strips that a cache of transformed vertices likes: where they are cut, which ends are joined, and the order and the
// direction in which they are drawn.
//
//   stripify(mesh, Effort::fast, Cost::indices());
//   const Strips strips = strips_for_vertex_cache(mesh, {.size = 32});
//   const std::vector<std::uint32_t> indices = strip_indices(mesh, strips);
//
// Long strips take few indices but miss the cache for every triangle: when the next strip runs along the last one, its
// vertices have left the cache. Cut to what the cache holds, and drawn side by side, strips miss it as rarely as a
// triangle list in cache order, with less than half of the indices. The idea of simulating the cache to decide where a
// strip ends is Hoppe's ("Optimization of mesh locality for transparent vertex caching", 1999); going back to triangles
// left behind follows Sander, Nehab, Barczak ("Fast triangle reordering for vertex locality and reduced overdraw",
// 2007).
#pragma once

#include <cstddef>

#include "restrip/mesh/strip_mesh.hpp"
#include "restrip/output/strips.hpp"

namespace restrip {

/// The cache that strips are made for.
struct VertexCache {
  /// Vertices that it holds, first in, first out; 0: none. For hardware that is not known, 16.
  std::size_t size = 0;
  /// Indices that a miss is worth, up to 1000: less means fewer indices, more means fewer misses. 0: the default, which
  /// follows the strips to begin with. With 1.19 indices a triangle it is 0.85, or 1.3 for fewer than 24 vertices; 0.62
  /// of that with 1.12 or less, four times that with 1.42 or more.
  double weight = 0;
};

/// Cuts and joins the strips of `mesh`, a valid colouring, so that 3 S + W (three indices for each strip, one for each
/// swap) plus `cache.weight` for each miss of the cache becomes small, and returns the strips in the order and the
/// direction in which they are to be drawn (Strips::directed). The colours of `mesh` become the returned strips. Call
/// stripify() with Cost::indices() first. A size of 0 changes nothing and returns extract_strips(mesh).
///
/// Greedy, linear time: for each strip drawn, at most some 50 beginnings of at most 128 triangles are compared; some
/// microseconds a triangle for a cache of 32. About 80 bytes a triangle during the call. Deterministic, the same on
/// every machine. Throws std::invalid_argument if the weight is not in its range.
Strips strips_for_vertex_cache(StripMesh& mesh, const VertexCache& cache);

}  // namespace restrip
