// The vertex work of an index buffer: misses of a small cache of transformed vertices.
//
// The usual measures: ACMR, the average misses per triangle (Hoppe, "Optimization of mesh locality for transparent
// vertex caching", 1999), and ATVR, misses per vertex, which is at best 1. The cache is first in, first out, as in
// meshoptimizer's analyzer with a warp size and a primitive group size of 0: a hit does not change the order, and each
// index is looked up, even if its triangle is degenerate.
//
//   const std::vector<std::uint32_t> indices = strip_indices(mesh, extract_strips(mesh));
//   const double misses_per_triangle = acmr(indices, 16, mesh.triangle_count());
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace restrip {

/// Misses of a cache of `cache_size` vertices, empty at first, that reads the indices of triangle lists or strips in
/// their order. 0xFFFFFFFF restarts a strip and is not a vertex. Linear time; 8 bytes for each vertex up to the largest
/// index. Without a cache, `cache_size` 0, each index is a miss.
[[nodiscard]] inline std::size_t vertex_cache_misses(std::span<const std::uint32_t> indices, std::size_t cache_size) {
  constexpr std::uint32_t restart = 0xFFFFFFFFU;
  std::size_t vertices = 0;
  for (const std::uint32_t v : indices)
    if (v != restart) vertices = (std::max)(vertices, v + std::size_t{1});
  // A vertex is in the cache until `cache_size` others have entered after it.
  std::vector<std::size_t> came_in(vertices, 0);  // the number of the miss; 0: never
  std::size_t misses = 0;
  for (const std::uint32_t v : indices)
    if (v != restart && (came_in[v] == 0 || misses - came_in[v] >= cache_size)) came_in[v] = ++misses;
  return misses;
}

/// vertex_cache_misses() divided by `triangles`, the number of triangles drawn; 0 if `triangles` is 0.
[[nodiscard]] inline double acmr(std::span<const std::uint32_t> indices, std::size_t cache_size,
                                 std::size_t triangles) {
  if (triangles == 0) return 0;
  return static_cast<double>(vertex_cache_misses(indices, cache_size)) / static_cast<double>(triangles);
}

}  // namespace restrip
