// The order of strips in an index buffer, and the end at which each begins: both are free, and decide how often a
// vertex is transformed.
//
//   const Strips strips = order_for_vertex_cache(mesh, extract_strips(mesh));
//   const std::vector<std::uint32_t> indices = strip_indices(mesh, strips);
//
// Greedy: next comes the strip that the vertices in the cache spare the largest share of the misses of its beginning,
// counted by simulating the cache; where none spares any, a strip next to the last written ones. (The way back to what
// was left behind follows Sander, Nehab, Barczak, "Fast triangle reordering for vertex locality and reduced overdraw",
// 2007; their unit is the triangle.)
#pragma once

#include <cstddef>

#include "restrip/mesh/numbered_mesh.hpp"
#include "restrip/output/strips.hpp"

namespace restrip {

/// How much order_for_vertex_cache() did.
struct StripOrderCounts {
  std::size_t tried = 0;         ///< beginnings of strips that were compared
  std::size_t indices_read = 0;  ///< of these
};

/// The strips in an order for a vertex cache, some of them from their other end, so that strip_indices(mesh, …) has as
/// many indices and draws the same triangles, and a cache of `cache_size` vertices, first in, first out, misses less
/// often (vertex_cache.hpp counts that). A strip is turned only where that takes no index more. `strips` must be those
/// of the mesh as it is now. Linear time: at most 64 beginnings of at most 2 * cache_size indices are compared for each
/// strip. Deterministic. About 60 bytes a triangle for the time of the call. A `cache_size` of 0 means no cache:
/// nothing changes.
template <NumberedMesh Mesh>
[[nodiscard]] Strips order_for_vertex_cache(const Mesh& mesh, const Strips& strips, std::size_t cache_size = 16,
                                            StripOrderCounts* counts = nullptr);

}  // namespace restrip

#include "restrip/output/impl/strip_order.hpp"
