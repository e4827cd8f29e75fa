// Strips in the order for a vertex cache are the same strips: the buffer draws each triangle once with its winding and
// has the same number of indices. A cache misses no more often than before, and on all meshes together less often.
#include "restrip/output/strip_order.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <vector>

#include "restrip/output/check_buffer.hpp"
#include "restrip/output/vertex_cache.hpp"
#include "restrip/search/stripify.hpp"
#include "sample_meshes.hpp"

namespace restrip {
namespace {

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
  return {StripMesh(),       sample::octahedron(),      sample::double_cone(300),
          sample::sphere(4), sample::rectangle(40, 30), sample::torus(40, 30, 2)};
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
      EXPECT_LE(vertex_cache_misses(in_order, cache_size), vertex_cache_misses(indices, cache_size));
      before += vertex_cache_misses(indices, cache_size);
      after += vertex_cache_misses(in_order, cache_size);
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
