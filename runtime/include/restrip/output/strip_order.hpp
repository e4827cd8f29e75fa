// Orders the strips of an index buffer and chooses the end at which each begins. Both decide how often a vertex is
// transformed.
//
//   const Strips strips = order_for_vertex_cache(mesh, extract_strips(mesh));
//   const std::vector<std::uint32_t> indices = strip_indices(mesh, strips);
//
// Greedy: next comes the strip whose beginning has the largest share of cache hits, counted by simulating the cache; if
// no strip has any, a strip next to the last written ones. (Going back to strips left behind follows Sander, Nehab,
// Barczak, "Fast triangle reordering for vertex locality and reduced overdraw", 2007; their unit is the triangle.)
#pragma once

#include <cstddef>

#include "restrip/mesh/numbered_mesh.hpp"
#include "restrip/output/strips.hpp"

namespace restrip {

/// Orders strips for a first-in-first-out vertex cache of `cache_size` vertices, and reverses some, so that it misses
/// less often (vertex_cache.hpp counts misses). strip_indices(mesh, …) draws the same triangles with the same number of
/// indices: a strip is reversed only if that takes no additional index. `strips` must be the strips of the mesh as it
/// is now. Linear time: at most 64 beginnings of at most 2 * cache_size indices are compared for each strip.
/// Deterministic. Needs about 60 bytes a triangle during the call. A `cache_size` of 0 means no cache: nothing changes.
template <NumberedMesh Mesh>
[[nodiscard]] Strips order_for_vertex_cache(const Mesh& mesh, const Strips& strips, std::size_t cache_size = 16);

}  // namespace restrip

#include "restrip/output/impl/strip_order.hpp"
