// Strips for a vertex cache draw the triangles of the mesh, each once with its winding; the colours of the mesh are
// these strips, and valid. With the default weight misses are few, and more weight trades indices for misses.
#include "restrip/output/strip_order.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <vector>

#include "form_reader.hpp"
#include "measure/vertex_cache.hpp"
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

struct Counts {
  std::size_t triangles = 0;
  std::size_t indices = 0;
  std::size_t misses = 0;
};

// Makes strips for the cache and checks them.
Counts checked(StripMesh mesh, const VertexCache& cache) {
  StripMesh again = mesh;
  const Strips strips = strips_for_vertex_cache(mesh, cache);
  EXPECT_TRUE(check_coloring(mesh).valid);
  EXPECT_EQ(as_set(strips), as_set(extract_strips(mesh)));
  const std::vector<std::uint32_t> indices = strip_indices(mesh, strips);
  EXPECT_EQ(form_reader::read_strips(std::span(indices)), sample::triangles_of(mesh));
  EXPECT_EQ(strips_for_vertex_cache(again, cache).order, strips.order) << "the same every time";
  return {mesh.triangle_count(), indices.size(), vertex_cache_misses(indices, cache.size)};
}

std::vector<StripMesh> meshes_to_order() {
  std::vector<StripMesh> all{StripMesh(),          sample::octahedron(),      sample::double_cone(300),
                             sample::sphere(4),    sample::rectangle(40, 30), sample::torus(40, 30, 2),
                             sample::tetrahedron()};
  // Two triangles with three common edges, a triangle alone, and edges of more than two triangles.
  all.push_back(StripMesh::build(std::vector<sample::Corners>{{0, 1, 2}, {2, 1, 0}, {3, 4, 5}}, 6));
  all.push_back(StripMesh::build(sample::with_backs(sample::book(5)), std::size_t{13} * 46));
  return all;
}

TEST(StripOrder, AnyStripsAndAnyCache) {
  for (StripMesh& mesh : meshes_to_order())
    for (const int colors : {0, 1, 2}) {
      if (colors != 0) stripify(mesh, Effort::fast, colors == 1 ? Cost::strips() : Cost::indices());
      for (const std::size_t size : {1U, 2U, 3U, 4U, 16U, 32U, 1000U, 4'000'000'000U})
        for (const double weight : {0.0, 1e-9, 3.0, 1000.0}) checked(mesh, {size, weight});
      StripMesh same = mesh;
      EXPECT_EQ(strips_for_vertex_cache(same, {}).order, extract_strips(mesh).order);
    }
}

// In rows as long as the cache allows, half a miss a triangle, and some at the ends of the rows.
TEST(StripOrder, FewMissesAndFewIndices) {
  for (const auto& [size, most_misses, most_indices] : {std::tuple{16U, 0.72, 1.49}, {32U, 0.64, 1.43}}) {
    for (StripMesh mesh : {sample::sphere(5), sample::torus(70, 60, 2), sample::rectangle(90, 60)}) {
      stripify(mesh, Effort::fast, Cost::indices());
      const Counts here = checked(mesh, {.size = size});
      EXPECT_LE(here.misses, most_misses * static_cast<double>(here.triangles));
      EXPECT_LE(here.indices, most_indices * static_cast<double>(here.triangles));
    }
  }
}

// Each strip begins with its first triangle, also if that takes an index more.
TEST(StripOrder, StripsAreWrittenInTheirDirection) {
  StripMesh mesh = sample::sphere(5);
  stripify(mesh, Effort::fast, Cost::indices());
  Strips strips = strips_for_vertex_cache(mesh, {.size = 16});
  ASSERT_TRUE(strips.directed);
  const std::vector<std::uint32_t> indices = strip_indices(mesh, strips);
  std::size_t at = 0;
  for (std::size_t s = 0; s < strips.size(); ++s) {
    const auto corners = mesh.corners(strips[s].front());
    for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(std::count(corners.begin(), corners.end(), indices[at + i]), 1);
    while (at < indices.size() && indices[at] != restart_index) ++at;
    ++at;
  }
  strips.directed = false;
  const std::vector<std::uint32_t> shorter = strip_indices(mesh, strips);
  EXPECT_LT(shorter.size(), indices.size());
  EXPECT_GT(vertex_cache_misses(shorter, 16), vertex_cache_misses(indices, 16));
}

TEST(StripOrder, WeightTradesIndicesForMisses) {
  StripMesh mesh = sample::torus(70, 60, 2);
  stripify(mesh, Effort::fast, Cost::indices());
  for (const std::size_t size : {16U, 32U}) {
    Counts before{0, 0, mesh.triangle_count()};
    for (const double weight : {0.01, 0.5, 1.0, 2.0, 5.0}) {
      const Counts here = checked(mesh, {size, weight});
      EXPECT_GT(100 * here.indices, 99 * before.indices) << weight;  // ties of the search move it by a fraction
      EXPECT_LT(here.misses, before.misses) << weight;
      before = here;
    }
    EXPECT_LE(100 * checked(mesh, {size, 0.01}).indices, 104 * strip_indices(mesh).size());
  }
}

// Without a strip a triangle has three indices and more, in the rows of a grid little more than one.
TEST(StripOrder, TheDefaultWeightFollowsTheStrips) {
  const auto drawn = [](StripMesh mesh, const VertexCache& cache) {
    return strips_for_vertex_cache(mesh, cache).order;
  };
  const StripMesh single = sample::torus(40, 30, 2);
  std::vector<sample::Corners> squares;
  for (std::uint32_t v = 0; v < 40 * 41; ++v) {
    if (v % 41 == 40) continue;
    squares.push_back({v, v + 1, v + 42});
    squares.push_back({v, v + 42, v + 41});
  }
  StripMesh grid = StripMesh::build(squares, std::size_t{41} * 41);
  stripify(grid, Effort::fast, Cost::indices());
  EXPECT_EQ(drawn(single, {32, 0}), drawn(single, {32, 4 * 0.85}));
  EXPECT_EQ(drawn(single, {16, 0}), drawn(single, {16, 4 * 1.3}));
  EXPECT_EQ(drawn(grid, {32, 0}), drawn(grid, {32, 0.62 * 0.85}));
  EXPECT_EQ(drawn(grid, {16, 0}), drawn(grid, {16, 0.62 * 1.3}));
  for (const StripMesh& mesh : {single, grid}) EXPECT_NE(drawn(mesh, {32, 0}), drawn(mesh, {32, 1}));
}

TEST(StripOrder, WeightIsChecked) {
  StripMesh mesh = sample::octahedron();
  for (const double weight : {-1.0, 1000.5, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_THROW(strips_for_vertex_cache(mesh, {16, weight}), std::invalid_argument);
}

}  // namespace
}  // namespace restrip
