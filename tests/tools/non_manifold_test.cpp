// Meshes with edges of more than two triangles, real and made, take no more indices than meshoptimizer needs, in the
// given order and in its vertex-cache order, with and without restarts.
#include <gtest/gtest.h>
#include <meshoptimizer.h>

#include <algorithm>
#include <initializer_list>
#include <string>
#include <vector>

#include "../runtime/sheets.hpp"
#include "lod/mesh_files.hpp"
#include "real_meshes.hpp"
#include "restrip/search/stripify.hpp"
#include "restrip/search/strips_of.hpp"

namespace restrip::tools {
namespace {

using List = std::vector<unsigned>;

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
