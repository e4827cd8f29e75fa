// Misses of the hardware models are those of meshoptimizer's analyser, and strips for a vertex cache have fewer indices
// and miss it less often than meshoptimizer's strips, on made meshes and, by the margins below, on real ones.
#include <gtest/gtest.h>
#include <meshoptimizer.h>

#include <cstddef>
#include <initializer_list>
#include <random>
#include <string>
#include <vector>

#include "../runtime/sample_meshes.hpp"
#include "lod/mesh_files.hpp"
#include "measure/vertex_cache.hpp"
#include "real_meshes.hpp"
#include "restrip/output/strip_order.hpp"
#include "restrip/search/stripify.hpp"

namespace restrip::tools {
namespace {

using List = std::vector<unsigned>;

List list_of(const StripMesh& mesh) {
  List list;
  for (Triangle t = 0; t < mesh.triangle_bound(); ++t)
    for (const Vertex v : mesh.corners(t)) list.push_back(v);
  return list;
}

List strips_of_meshoptimizer(const StripMesh& mesh) {
  const List list = list_of(mesh);
  List ordered(list.size());
  meshopt_optimizeVertexCacheStrip(ordered.data(), list.data(), list.size(), mesh.vertex_bound());
  List strips(meshopt_stripifyBound(list.size()));
  strips.resize(meshopt_stripify(strips.data(), ordered.data(), list.size(), mesh.vertex_bound(), restart_index));
  return strips;
}

void expect_misses_of_meshoptimizer(const List& strips, std::size_t vertices, const std::string& name) {
  List list(meshopt_unstripifyBound(strips.size()));
  list.resize(meshopt_unstripify(list.data(), strips.data(), strips.size(), restart_index));
  for (const CacheModel& cache : {amd_cache, nvidia_cache, intel_cache, CacheModel{3, 0, 1}, CacheModel{5, 7, 0}})
    EXPECT_EQ(vertex_cache_misses(strips, cache),
              meshopt_analyzeVertexCache(list.data(), list.size(), vertices, static_cast<unsigned>(cache.vertices),
                                         static_cast<unsigned>(cache.warp), static_cast<unsigned>(cache.triangles))
                  .vertices_transformed)
        << name << ": " << cache.vertices << ", " << cache.warp << ", " << cache.triangles;
}

std::size_t misses_of_list(const StripMesh& mesh, std::size_t size) {
  const List list = list_of(mesh);
  List ordered(list.size());
  meshopt_optimizeVertexCache(ordered.data(), list.data(), list.size(), mesh.vertex_bound());
  return vertex_cache_misses(ordered, size);
}

// Percentages of meshoptimizer's counts that ours may reach.
struct Margins {
  std::size_t size;
  std::size_t indices;
  std::size_t misses;
  std::size_t misses_of_list;
  std::size_t nvidia;
};

void expect_better_than_meshoptimizer(StripMesh mesh, const std::string& name, std::initializer_list<Margins> margins) {
  const List theirs = strips_of_meshoptimizer(mesh);
  expect_misses_of_meshoptimizer(theirs, mesh.vertex_bound(), name);
  stripify(mesh, Effort::fast, Cost::indices());
  for (const Margins& most : margins) {
    SCOPED_TRACE(name + ", " + std::to_string(most.size));
    StripMesh own = mesh;
    const List ours = strip_indices(own, strips_for_vertex_cache(own, {.size = most.size}));
    expect_misses_of_meshoptimizer(ours, mesh.vertex_bound(), name);
    const std::size_t misses = vertex_cache_misses(ours, most.size);
    EXPECT_LE(100 * ours.size(), most.indices * theirs.size());
    EXPECT_LE(100 * misses, most.misses * vertex_cache_misses(theirs, most.size));
    EXPECT_LE(100 * misses, most.misses_of_list * misses_of_list(mesh, most.size));
    EXPECT_LE(100 * vertex_cache_misses(ours, nvidia_cache), most.nvidia * vertex_cache_misses(theirs, nvidia_cache));
  }
}

TEST(VertexCacheModels, RandomStrips) {
  std::mt19937 random(5);
  for (const unsigned vertices : {3U, 20U, 60U, 500U}) {
    List strips(2000);
    for (unsigned& v : strips) v = random() % 7 == 0 ? restart_index : static_cast<unsigned>(random()) % vertices;
    expect_misses_of_meshoptimizer(strips, vertices, std::to_string(vertices));
  }
}

TEST(VertexCacheModels, StripsBeatMeshoptimizersOnMadeMeshes) {
  const std::initializer_list<Margins> margins{{16, 102, 90, 107, 95}, {32, 96, 96, 106, 100}};
  expect_better_than_meshoptimizer(sample::torus(90, 60, 2), "torus", margins);
  expect_better_than_meshoptimizer(sample::rectangle(120, 80), "rectangle", margins);
}

class RealVertexCaches : public testing::TestWithParam<const char*> {};

TEST_P(RealVertexCaches, StripsBeatMeshoptimizers) {
  const auto file = REAL_MESH(GetParam());
  const Soup soup = read_mesh(file);
  expect_better_than_meshoptimizer(StripMesh::build(soup.triangles, soup.points.size()), file.string(),
                                   {{16, 100, 85, 107, 95}, {32, 95, 95, 106, 101}});
}

INSTANTIATE_TEST_SUITE_P(VertexCacheModels, RealVertexCaches,
                         testing::Values("bunny.obj", "nefertiti.obj", "fandisk.obj", "rocker-arm.obj"));

}  // namespace
}  // namespace restrip::tools
