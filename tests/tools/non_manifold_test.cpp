// Real meshes with edges of more than two triangles take no more indices than meshoptimizer needs, in the given order
// and in its vertex-cache order, with and without restarts.
#include <gtest/gtest.h>
#include <meshoptimizer.h>

#include <algorithm>
#include <vector>

#include "lod/mesh_files.hpp"
#include "real_meshes.hpp"
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

void expect_no_more(const std::filesystem::path& file) {
  const Soup soup = read_mesh(file);
  List list;
  for (const Corners& t : soup.triangles)
    if (!degenerate(t)) list.insert(list.end(), t.begin(), t.end());
  for (const StripForm form : {StripForm::restart, StripForm::stitched})
    EXPECT_LE(strips_of(list, soup.points.size(), {.form = form}).size(),
              by_meshoptimizer(list, soup.points.size(), form == StripForm::restart ? ~0U : 0U))
        << file;
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
