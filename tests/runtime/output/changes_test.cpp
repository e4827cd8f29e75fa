// What is handed on of a list of changes: triangles added, removed and changed.
#include "restrip/output/changes.hpp"

#include <gtest/gtest.h>

#include <random>
#include <set>

#include "random_operation.hpp"
#include "sample_meshes.hpp"

namespace restrip {
namespace {

TEST(ChangeFeed, AddsUpToTheMesh) {
  StripMesh mesh = sample::torus(8, 7);
  std::vector<Triangle> changed;
  mesh.watch(&changed);
  Keeper keeper(mesh, Policy::quick, Cost::strips());
  ChangeFeed feed(mesh);
  std::set<Triangle> known;
  for (Triangle t = 0; t < mesh.triangle_bound(); ++t) known.insert(t);
  std::mt19937 random(1);
  for (int frame = 0; frame < 200; ++frame) {
    for (int n = 0; n < 4; ++n) random_operation(keeper, random, frame % 40 < 20);
    feed.update(mesh, changed);
    changed.clear();
    for (const Triangle t : feed.added()) ASSERT_TRUE(known.insert(t).second);
    for (const Triangle t : feed.removed()) ASSERT_EQ(known.erase(t), 1U);
    for (const Triangle t : feed.changed()) ASSERT_EQ(known.count(t), 1U);
    ASSERT_EQ(known.size(), mesh.triangle_count());
    for (const Triangle t : known) ASSERT_TRUE(mesh.alive(t));
  }
}

}  // namespace
}  // namespace restrip
