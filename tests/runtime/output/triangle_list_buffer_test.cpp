// Only changed corners of a list are written; that it draws the mesh is in live_random_test.cpp.
#include "output/triangle_list_buffer.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

#include "restrip/operations/operations.hpp"
#include "restrip/search/keeper.hpp"
#include "sample_meshes.hpp"

namespace restrip {
namespace {

// A flip changes two corners, a split one of each triangle that goes to the new vertex and two triangles.
TEST(TriangleListBuffer, WritesTheCornersThatChanged) {
  StripMesh mesh = sample::torus(30, 30);
  std::vector<Triangle> changed;
  mesh.watch(&changed);
  TriangleListBuffer buffer(mesh);
  const auto written = [&] {
    std::size_t sum = 0;
    for (const auto& range : buffer.update(mesh, changed)) sum += range.count;
    changed.clear();
    return sum;
  };
  const StripMesh::Halfedge h = mesh.spoke(100);
  split(mesh, {h, turn_cw(mesh, turn_cw(mesh, h))});
  EXPECT_EQ(written(), 2U + 6U);
  EXPECT_EQ(written(), 0U);
  const StripMesh beyond = StripMesh::build(std::vector<sample::Corners>{{0, 1, 65'535}}, 65'536);
  EXPECT_THROW(TriangleListBuffer(beyond, IndexWidth::bits16), std::length_error);
}

TEST(TriangleListBuffer, PaddingIsWrittenOnlyWhenItChanges) {
  StripMesh mesh = StripMesh::build(std::vector<sample::Corners>{{0, 1, 2}, {2, 1, 3}, {4, 5, 6}}, 7);
  std::vector<Triangle> changed;
  mesh.watch(&changed);
  TriangleListBuffer buffer(mesh, IndexWidth::bits16);
  ASSERT_EQ(buffer.indices16().size(), 10U);
  EXPECT_TRUE(buffer.update(mesh, changed, {.merge_gap = 0, .align = 2}).empty());
  Keeper keeper(mesh, Policy::bare, Cost::indices());
  keeper.flip(mesh.spoke(1, 2));
  const auto ranges = buffer.update(mesh, changed, {.merge_gap = 0, .align = 2});
  ASSERT_FALSE(ranges.empty());
  EXPECT_LE(ranges.back().first + ranges.back().count, 6U);
}

}  // namespace
}  // namespace restrip
