// Strips for a vertex cache have fewer indices and miss it less often than meshoptimizer's strips, on made meshes and,
// by the margins below, on real ones; by meshoptimizer's analyser also on hardware as NVidia's. Meshes with edges of
// more than two triangles take no more indices than meshoptimizer needs, in the given order and in its vertex-cache
// order, with and without restarts.
#include <gtest/gtest.h>
#include <meshoptimizer.h>

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <string>
#include <vector>

#include "../runtime/sample_meshes.hpp"
#include "folders.hpp"
#include "lod/mesh_files.hpp"
#include "measure/vertex_cache.hpp"
#include "restrip/output/strip_order.hpp"
#include "restrip/search/stripify.hpp"
#include "restrip/search/strips_of.hpp"

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

/// As meshoptimizer models it: a cache of 32 vertices, emptied after 32 misses or triangles.
std::size_t misses_of_nvidia(const List& strips, std::size_t vertices) {
  List list(meshopt_unstripifyBound(strips.size()));
  list.resize(meshopt_unstripify(list.data(), strips.data(), strips.size(), restart_index));
  return meshopt_analyzeVertexCache(list.data(), list.size(), vertices, 32, 32, 32).vertices_transformed;
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
  stripify(mesh, Effort::fast, Cost::indices());
  for (const Margins& most : margins) {
    SCOPED_TRACE(name + ", " + std::to_string(most.size));
    StripMesh own = mesh;
    const List ours = strip_indices(own, strips_for_vertex_cache(own, {.size = most.size}));
    const std::size_t misses = vertex_cache_misses(ours, most.size);
    EXPECT_LE(100 * ours.size(), most.indices * theirs.size());
    EXPECT_LE(100 * misses, most.misses * vertex_cache_misses(theirs, most.size));
    EXPECT_LE(100 * misses, most.misses_of_list * misses_of_list(mesh, most.size));
    EXPECT_LE(100 * misses_of_nvidia(ours, mesh.vertex_bound()),
              most.nvidia * misses_of_nvidia(theirs, mesh.vertex_bound()));
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

// ---- edges of more than two triangles

std::size_t by_meshoptimizer(const List& list, std::size_t vertices, unsigned restart) {
  List ordered(list.size());
  meshopt_optimizeVertexCacheStrip(ordered.data(), list.data(), list.size(), vertices);
  std::size_t fewest = list.size();
  for (const List& each : {list, ordered}) {
    List out(meshopt_stripifyBound(list.size()));
    fewest = std::min(fewest, meshopt_stripify(out.data(), each.data(), list.size(), vertices, restart));
  }
  return fewest;
}

template <class Triangles>
void expect_no_more(const Triangles& triangles, std::size_t vertices, const std::string& name,
                    std::initializer_list<StripForm> forms = {StripForm::restart, StripForm::stitched}) {
  List list;
  for (const auto& t : triangles)
    if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) list.insert(list.end(), t.begin(), t.end());
  for (const StripForm form : forms)
    EXPECT_LE(strips_of(list, vertices, {.form = form}).size(),
              by_meshoptimizer(list, vertices, form == StripForm::restart ? ~0U : 0U))
        << name;
}
void expect_no_more(const std::filesystem::path& file) {
  const Soup soup = read_mesh(file);
  expect_no_more(soup.triangles, soup.points.size(), file.string());
}

TEST(NonManifold, MadeMeshesTakeNoMoreThanMeshoptimizer) {
  const auto grid = [](Vertex n) {
    return sample::with_backs(sample::sheet(n, n, [n](Vertex x, Vertex y) { return (n + 1) * x + y; }));
  };
  for (const Vertex n : {3U, 6U, 40U}) expect_no_more(grid(n), std::size_t{n + 1} * (n + 1), "two-sided sheet");
  for (const Vertex pages : {3U, 4U, 7U, 12U}) {
    const std::size_t vertices = 13 * (9 * std::size_t{pages} + 1);
    // Pages are grids, for which meshoptimizer finds strips that need no index for their winding when they are
    // stitched.
    expect_no_more(sample::book(pages), vertices, "book", {StripForm::restart});
    expect_no_more(sample::with_backs(sample::book(pages)), vertices, "two-sided book");
  }
  for (const Vertex length : {5U, 31U, 32U})
    expect_no_more(sample::with_backs(sample::band(length)), std::size_t{2} * length, "band with half a turn");
  for (const Vertex count : {2U, 3U, 5U}) expect_no_more(sample::boxes(count), std::size_t{125} * count, "boxes");
}

TEST(NonManifold, BeetleTakesNoMoreThanMeshoptimizer) {
  const auto file = REAL_MESH("beetle_nm.obj");
  expect_no_more(file);
}

TEST(NonManifold, BadMeshesTakeNoMoreThanMeshoptimizer) {
  const auto folder = REAL_MESH("bad");
  std::size_t meshes = 0;
  for (const auto& file : std::filesystem::directory_iterator(folder)) {
    expect_no_more(file.path());
    ++meshes;
  }
  EXPECT_GT(meshes, 0U);
}

}  // namespace
}  // namespace restrip::tools
