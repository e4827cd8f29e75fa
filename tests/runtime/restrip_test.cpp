// One include is enough for the first page of the manual: strips from scratch, operations under a keeper, an index
// buffer in step. No other header of restrip is included here.
#include "restrip/restrip.hpp"

#include <gtest/gtest.h>

namespace restrip {
namespace {

TEST(OneInclude, IsEnough) {
  const std::vector<std::uint32_t> triangles{0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5};
  StripMesh mesh = StripMesh::build(triangles, 6);
  EXPECT_EQ(stripify(mesh, Effort::full, Cost::strips()), 1U);
  std::vector<Triangle> changed;
  mesh.watch(&changed);
  LiveBuffer buffer({.width = IndexWidth::bits32});
  buffer.rebuild(mesh);
  Keeper keeper(mesh, Policy::quick, Cost::strips());
  const StripMesh::Halfedge spoke = mesh.spoke(4);
  const Checked up = checked_split(keeper, {spoke, turn_ccw(mesh, turn_ccw(mesh, spoke))});
  ASSERT_TRUE(up);
  EXPECT_FALSE(buffer.update(mesh, changed).empty());
  EXPECT_GE(buffer.indices().size(), mesh.triangle_count() + 2);
  LiveBuffer list({.form = StripForm::list, .width = IndexWidth::bits32});
  list.rebuild(mesh);
  EXPECT_EQ(list.indices().size(), 3U * 10);
  EXPECT_TRUE(checked_collapse(keeper, up.rewrite.halfedge));
  EXPECT_EQ(keeper.strips(), check_coloring(mesh).strips);
  EXPECT_TRUE(split_rule({4, 2}, 0, 0).valid);
  BakedFile file;
  EXPECT_NE(read_baked({}, file), "");
}

}  // namespace
}  // namespace restrip
