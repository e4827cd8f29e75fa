// Strips in the order for a vertex cache are the same strips: the buffer draws each triangle once with its winding and
// has the same number of indices. A cache that is simulated here by a queue misses no more often than before, and on
// all meshes together less often.
#include "restrip/output/strip_order.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <deque>
#include <vector>

#include "restrip/output/check_buffer.hpp"
#include "restrip/search/stripify.hpp"
#include "sample_meshes.hpp"

namespace restrip {
namespace {

std::size_t misses_of_queue(const std::vector<std::uint32_t>& indices, std::size_t cache_size) {
  std::deque<std::uint32_t> cache;
  std::size_t misses = 0;
  for (const std::uint32_t v : indices) {
    if (v == restart_index || std::find(cache.begin(), cache.end(), v) != cache.end()) continue;
    ++misses;
    cache.push_back(v);
    if (cache.size() > cache_size) cache.pop_front();
  }
  return misses;
}

// Each strip as it is read from the end with the lower handle, all sorted.
std::vector<std::vector<Triangle>> as_set(const Strips& strips) {
  std::vector<std::vector<Triangle>> all;
  for (std::size_t s = 0; s < strips.size(); ++s) {
    all.emplace_back(strips[s].begin(), strips[s].end());
    if (all.back().back() < all.back().front()) std::reverse(all.back().begin(), all.back().end());
  }
  std::sort(all.begin(), all.end());
  return all;
}

std::vector<StripMesh> meshes_to_order() {
  std::vector<StripMesh> all;
  all.push_back(StripMesh());
  all.push_back(sample::octahedron());
  all.push_back(sample::double_cone(300));
  all.push_back(sample::sphere(4));
  all.push_back(StripMesh::build(sample::grid(40, 30, false, false, 1), 1271));
  all.push_back(StripMesh::build(sample::grid(40, 30, true, true, 2), 1200));
  return all;
}

TEST(StripOrder, TheSameStripsAreMissedLessOften) {
  for (const std::size_t cache_size : {std::size_t{16}, std::size_t{32}}) {
    std::size_t before = 0;
    std::size_t after = 0;
    for (StripMesh& mesh : meshes_to_order()) {
      stripify(mesh, Effort::fast, Cost::indices());
      const Strips strips = extract_strips(mesh);
      const Strips ordered = order_for_vertex_cache(mesh, strips, cache_size);
      EXPECT_EQ(as_set(ordered), as_set(strips));
      const std::vector<std::uint32_t> indices = strip_indices(mesh, strips);
      const std::vector<std::uint32_t> in_order = strip_indices(mesh, ordered);
      EXPECT_EQ(in_order.size(), indices.size());
      EXPECT_EQ(triangles_of_strips(std::span<const std::uint32_t>(in_order)),
                triangles_of_strips(std::span<const std::uint32_t>(indices)));
      EXPECT_EQ(triangles_of_strips(std::span<const std::uint32_t>(in_order)).size(), mesh.triangle_count());
      EXPECT_LE(misses_of_queue(in_order, cache_size), misses_of_queue(indices, cache_size));
      before += misses_of_queue(indices, cache_size);
      after += misses_of_queue(in_order, cache_size);
      EXPECT_EQ(order_for_vertex_cache(mesh, strips, cache_size).order, ordered.order) << "the same every time";
    }
    EXPECT_LT(static_cast<double>(after), 0.99 * static_cast<double>(before));
  }
}

// Without any colours each triangle is a strip; the smallest caches, and none.
TEST(StripOrder, AnyStripsAndAnyCache) {
  for (StripMesh& mesh : meshes_to_order())
    for (const bool colors : {false, true}) {
      if (colors) stripify(mesh, Effort::fast, Cost::strips());
      const Strips strips = extract_strips(mesh);
      for (const std::size_t cache_size : {0U, 1U, 3U, 1000U}) {
        const Strips ordered = order_for_vertex_cache(mesh, strips, cache_size);
        EXPECT_EQ(as_set(ordered), as_set(strips));
        EXPECT_EQ(strip_index_count(mesh, ordered), strip_index_count(mesh, strips));
        EXPECT_TRUE(cache_size != 0 || ordered.order == strips.order);
      }
    }
}

}  // namespace
}  // namespace restrip
