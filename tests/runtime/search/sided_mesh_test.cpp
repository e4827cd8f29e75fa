// A view by sides answers what the mesh answers, and what a StripMesh of the same triangles answers.
#include "restrip/search/sided_mesh.hpp"

#include <gtest/gtest.h>

namespace restrip {
namespace {
TEST(SidedMesh, Todo) { EXPECT_TRUE(SidedMesh<StripMesh>); }
}  // namespace
}  // namespace restrip
