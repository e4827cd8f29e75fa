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
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "restrip/precondition.hpp"

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

/// A cache as hardware has it: first in, first out, and emptied when a group of triangles is full. The models are the
/// analyser's of meshoptimizer, and so are the figures for the hardware of three vendors.
struct CacheModel {
  std::size_t vertices;   ///< that it holds
  std::size_t warp;       ///< misses of a group; 0: any number
  std::size_t triangles;  ///< of a group; 0: any number
};
inline constexpr CacheModel amd_cache{14, 64, 128};
inline constexpr CacheModel nvidia_cache{32, 32, 32};
inline constexpr CacheModel intel_cache{128, 0, 0};

/// Misses of such a cache when strips with restart indices are drawn. Degenerate triangles are dropped before they
/// reach it. Linear time; 8 bytes for each vertex up to the largest index.
[[nodiscard]] inline std::size_t vertex_cache_misses(std::span<const std::uint32_t> strips, const CacheModel& cache) {
  constexpr std::uint32_t restart = 0xFFFFFFFFU;
  std::size_t vertices = 0;
  for (const std::uint32_t v : strips)
    if (v != restart) vertices = (std::max)(vertices, v + std::size_t{1});
  // Numbers of misses, with a gap where the cache is emptied.
  std::vector<std::size_t> came_in(vertices, 0);
  std::size_t clock = cache.vertices + 1;
  const auto missed = [&](std::uint32_t v) { return clock - came_in[v] > cache.vertices; };
  std::size_t misses = 0;
  std::size_t misses_of_group = 0;
  std::size_t triangles_of_group = 0;
  std::size_t start = 0;
  for (std::size_t i = 0; i < strips.size(); ++i) {
    if (strips[i] == restart) start = i + 1;
    if (i < start + 2) continue;
    std::array<std::uint32_t, 3> corners{strips[i - 2], strips[i - 1], strips[i]};
    if ((i - start) % 2 != 0) std::swap(corners[0], corners[1]);
    if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0]) continue;
    const auto missing = static_cast<std::size_t>(std::count_if(corners.begin(), corners.end(), missed));
    if ((cache.triangles != 0 && triangles_of_group == cache.triangles) ||
        (cache.warp != 0 && misses_of_group + missing > cache.warp)) {
      clock += cache.vertices + 1;
      misses_of_group = 0;
      triangles_of_group = 0;
    }
    for (const std::uint32_t v : corners) {
      if (!missed(v)) continue;
      came_in[v] = clock++;
      ++misses;
      ++misses_of_group;
    }
    ++triangles_of_group;
  }
  return misses;
}

/// Misses per triangle of the caches that reports show.
struct CacheReport {
  double fifo_16 = 0;
  double fifo_32 = 0;
  double amd = 0;
  double nvidia = 0;
  double intel = 0;
};

/// Of strips with restart indices that draw `triangles` triangles. Linear time.
[[nodiscard]] inline CacheReport cache_report(std::span<const std::uint32_t> strips, std::size_t triangles) {
  const auto of_model = [&](const CacheModel& cache) {
    const std::size_t misses = vertex_cache_misses(strips, cache);
    return triangles == 0 ? 0 : static_cast<double>(misses) / static_cast<double>(triangles);
  };
  return {acmr(strips, 16, triangles), acmr(strips, 32, triangles), of_model(amd_cache), of_model(nvidia_cache),
          of_model(intel_cache)};
}

}  // namespace restrip
