// The list draws the mesh after every update, indices not reported have not changed, and only changed corners are
// written.
#include "output/triangle_list_buffer.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <stdexcept>
#include <vector>

#include "buffer_changes.hpp"
#include "form_reader.hpp"
#include "random_operation.hpp"
#include "restrip/operations/operations.hpp"
#include "restrip/search/keeper.hpp"
#include "sample_meshes.hpp"

namespace restrip {
namespace {

TEST(TriangleListBuffer, FollowsAnyOperationsWithThreeIndicesATriangle) {
  std::mt19937 random(15);
  for (const unsigned most : {1U, 40U}) {
    for (StripMesh& mesh : sample::meshes()) {
      Keeper keeper(mesh, Policy::local, Cost::strips());
      std::vector<Triangle> changed;
      mesh.watch(&changed);
      TriangleListBuffer buffer(mesh);
      TriangleListBuffer narrow(mesh, IndexWidth::bits16);
      for (int round = 0; round < 100; ++round) {
        const std::vector<std::uint32_t> before(buffer.indices().begin(), buffer.indices().end());
        for (unsigned n = most == 1 ? 1 : static_cast<unsigned>(random() % most); n > 0; --n)
          random_operation(keeper, random, mesh.triangle_count() < 60 || (round / 25) % 2 == 0);
        const auto ranges = buffer.update(mesh, changed);
        expect_only_reported_changes(before, buffer.indices(), ranges);
        const std::vector<std::uint32_t> narrow_before(narrow.indices16().begin(), narrow.indices16().end());
        const auto narrow_ranges = narrow.update(mesh, changed, {.merge_gap = 0, .align = 2});
        const std::vector<std::uint32_t> narrow_after(narrow.indices16().begin(), narrow.indices16().end());
        expect_only_reported_changes(narrow_before, narrow_after, narrow_ranges);
        changed.clear();
        ASSERT_EQ(buffer.indices().size(), 3 * mesh.triangle_count());
        form_reader::Reader reader(std::as_bytes(buffer.indices()), 4);
        reader.list(0, buffer.indices().size());
        ASSERT_EQ(std::move(reader).triangles(), sample::triangles_of(mesh));
        // With 16 bits one more index makes a multiple of four bytes if necessary.
        ASSERT_EQ(narrow.indices16().size(), (buffer.indices().size() + 1) / 2 * 2);
        ASSERT_TRUE(std::equal(buffer.indices().begin(), buffer.indices().end(), narrow.indices16().begin()));
        if (HasFatalFailure()) return;
      }
      mesh.watch(nullptr);
    }
  }
}

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

TEST(TriangleListBuffer, AMeshWithoutTrianglesWritesNothing) {
  const StripMesh mesh = StripMesh::build(std::vector<sample::Corners>{}, 0);
  TriangleListBuffer buffer;
  EXPECT_TRUE(buffer.update(mesh, {}).empty());
  EXPECT_TRUE(buffer.indices().empty());
}

}  // namespace
}  // namespace restrip
