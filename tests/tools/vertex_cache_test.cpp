// Misses are counted with a queue of vertices, index by index.
#include "measure/vertex_cache.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <deque>
#include <random>
#include <vector>

namespace restrip {
namespace {

// The cache as a queue, vertex by vertex.
std::size_t misses_of_a_queue(const std::vector<std::uint32_t>& indices, std::size_t cache_size) {
  std::deque<std::uint32_t> cache;
  std::size_t misses = 0;
  for (const std::uint32_t v : indices) {
    if (v == 0xFFFFFFFFU || std::find(cache.begin(), cache.end(), v) != cache.end()) continue;
    ++misses;
    cache.push_back(v);
    if (cache.size() > cache_size) cache.pop_front();
  }
  return misses;
}

TEST(VertexCache, MissesAreTheMissesOfAQueue) {
  std::mt19937 random(3);
  for (const std::uint32_t vertices : {1U, 3U, 15U, 16U, 17U, 40U}) {
    std::vector<std::uint32_t> indices(500);
    for (std::uint32_t& v : indices) {
      v = static_cast<std::uint32_t>(random()) % vertices;
      if (random() % 9 == 0) v = 0xFFFFFFFFU;
    }
    for (const std::size_t cache_size : {0U, 1U, 2U, 3U, 16U, 32U}) {
      const std::size_t misses = misses_of_a_queue(indices, cache_size);
      EXPECT_EQ(vertex_cache_misses(indices, cache_size), misses) << vertices << ", " << cache_size;
      EXPECT_DOUBLE_EQ(acmr(indices, cache_size, 250), static_cast<double>(misses) / 250);
    }
  }
  EXPECT_EQ(vertex_cache_misses({}, 16), 0U);
  EXPECT_EQ(acmr({}, 16, 0), 0);
}

}  // namespace
}  // namespace restrip
