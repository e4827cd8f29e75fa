// No index buffer has fewer indices than the bound: all buffers of small meshes are tried, with degenerate triangles
// and windings of any kind. A zigzag of triangles reaches it.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <random>
#include <utility>
#include <vector>

#include "measure/index_bound.hpp"
#include "measure/vertex_cache.hpp"
#include "restrip/output/strips.hpp"
#include "restrip/search/stripify.hpp"
#include "runtime/sample_meshes.hpp"

namespace restrip::tools {
namespace {

using sample::Corners;

// The fewest indices of any buffer that draws each triangle once, found breadth first: only the triangles drawn and the
// last two indices matter. `no_vertex` stands for no index since the last restart.
std::size_t fewest_indices_of_any_buffer(const std::vector<Corners>& triangles, Vertex vertices) {
  struct State {
    std::size_t drawn;
    Vertex a;
    Vertex b;
  };
  const Vertex no_vertex = vertices;
  const std::size_t all = (std::size_t{1} << triangles.size()) - 1;
  std::map<std::array<Vertex, 3>, std::vector<std::size_t>> with_corners;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    Corners sorted = triangles[t];
    std::sort(sorted.begin(), sorted.end());
    with_corners[sorted].push_back(t);
  }
  std::vector<bool> met((all + 1) * (vertices + 1) * (vertices + 1), false);
  std::vector<State> now;
  std::vector<State> next;
  const auto reach = [&](std::size_t drawn, Vertex a, Vertex b) {
    const std::size_t place = (drawn * (vertices + 1) + a) * (vertices + 1) + b;
    if (!met[place]) next.push_back({drawn, a, b});
    met[place] = true;
  };
  reach(0, no_vertex, no_vertex);
  for (std::size_t indices = 0;; ++indices) {
    now.swap(next);
    next.clear();
    if (now.empty()) return 0;  // no buffer: fails the test
    for (const auto& [drawn, a, b] : now) {
      if (drawn == all) return indices;
      reach(drawn, no_vertex, no_vertex);  // a restart
      for (Vertex c = 0; c < vertices; ++c) {
        if (a == no_vertex || b == no_vertex || a == b || b == c || a == c) {
          reach(drawn, b, c);
          continue;
        }
        Corners sorted{a, b, c};
        std::sort(sorted.begin(), sorted.end());
        const auto found = with_corners.find(sorted);
        if (found == with_corners.end()) continue;
        for (const std::size_t t : found->second)
          if ((drawn >> t & 1U) == 0) reach(drawn | std::size_t{1} << t, b, c);
      }
    }
  }
}

// Lists of at most eight triangles: closed and open, of several components, with vertices that components share,
// triangles twice, windings that disagree, and any triples at all.
std::vector<std::pair<std::vector<Corners>, Vertex>> small_lists() {
  std::vector<std::pair<std::vector<Corners>, Vertex>> all{{{{0, 1, 2}}, 3},
                                                           {{{0, 1, 2}, {1, 0, 2}}, 3},
                                                           {{{0, 1, 2}, {0, 1, 2}}, 3},
                                                           {{{0, 1, 2}, {3, 4, 5}}, 6},
                                                           {{{0, 1, 2}, {2, 3, 4}}, 5},
                                                           {{{0, 1, 2}, {2, 3, 4}, {4, 5, 0}, {6, 7, 8}}, 9},
                                                           {{{0, 1, 2}, {0, 2, 3}, {0, 4, 5}, {0, 5, 6}, {0, 7, 8}}, 9},
                                                           {{{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}}, 4},
                                                           {{{0, 1, 2}, {0, 1, 3}, {0, 1, 4}, {1, 0, 5}}, 6},
                                                           {sample::triangles_of(sample::octahedron()), 6},
                                                           {sample::triangles_of(sample::double_cone(3)), 5},
                                                           {sample::triangles_of(sample::rectangle(2, 2)), 9},
                                                           {sample::triangles_of(sample::tube(3, 1)), 6}};
  std::mt19937 random(31);
  for (int i = 0; i < 60; ++i) {
    const Vertex vertices = 4 + static_cast<Vertex>(random() % 4);
    std::vector<Corners> list(1 + random() % 7);
    for (Corners& c : list) {
      std::array<Vertex, 8> order{0, 1, 2, 3, 4, 5, 6, 7};
      std::shuffle(order.begin(), order.begin() + vertices, random);
      c = {order[0], order[1], order[2]};
    }
    all.emplace_back(list, vertices);
  }
  return all;
}

TEST(IndexBound, IsNotPassedByAnyBufferOfSmallLists) {
  std::size_t reached = 0;
  for (const auto& [triangles, vertices] : small_lists()) {
    const std::size_t fewest = fewest_indices_of_any_buffer(triangles, vertices);
    const std::size_t bound = strip_index_lower_bound(triangles, vertices);
    EXPECT_LE(bound, fewest) << triangles.size() << " triangles of " << vertices << " vertices";
    reached += bound == fewest ? 1U : 0U;
  }
  EXPECT_GT(reached, 20U) << "a bound of nothing would pass as well";
  EXPECT_EQ(strip_index_lower_bound(StripMesh{}), 0U);
}

TEST(IndexBound, IsReachedByAZigzagAndByNoStripsPassed) {
  for (const Vertex triangles : {1U, 2U, 3U, 10U, 101U}) {
    std::vector<Corners> zigzag;
    for (Vertex t = 0; t < triangles; ++t) zigzag.push_back({t + t % 2, t + 1 - t % 2, t + 2});
    StripMesh mesh = StripMesh::build(zigzag, triangles + 2);
    EXPECT_EQ(strip_index_lower_bound(mesh), triangles + 2);
    stripify(mesh, Effort::fast, Cost::strips());
    EXPECT_EQ(strip_indices(mesh).size(), triangles + 2);
  }
  std::mt19937 random(6);
  for (StripMesh& mesh : sample::meshes()) {
    const std::size_t bound = strip_index_lower_bound(mesh);
    for (const double share : {0.0, 0.7, 1.0}) {
      sample::color_at_random(mesh, share, random);
      EXPECT_GE(strip_indices(mesh).size(), bound);
    }
    stripify(mesh, Effort::best, Cost::indices());
    EXPECT_GE(strip_indices(mesh).size(), bound);
    EXPECT_EQ(strip_index_lower_bound(mesh), bound) << "whatever the colours";
  }
}

// ---- misses of a vertex cache, counted with a queue of vertices, index by index

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
}  // namespace restrip::tools
