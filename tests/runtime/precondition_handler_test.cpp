// User-defined handlers replace the abort, with and without NDEBUG, and the exceptions; they receive the sentence, and
// for a precondition also the function.
#include <gtest/gtest.h>

#include "restrip/operations/operations.hpp"
#include "restrip/output/strips.hpp"
#include "sample_meshes.hpp"

namespace restrip {
namespace {

TEST(PreconditionHandler, IsCalledInPlaceOfTheAbort) {
  StripMesh mesh = sample::octahedron();
  const StripMesh::Halfedge h = mesh.spoke(4);
  try {
    split(mesh, {h, h});
    FAIL() << "nothing thrown";
  } catch (const std::logic_error& error) {
    EXPECT_EQ(std::string(error.what()), std::string("split: ") + describe(Refusal::same_spoke));
  }
  EXPECT_EQ(mesh.triangle_count(), 8U);
  split(mesh, {h, turn_ccw(mesh, h)});
  EXPECT_EQ(mesh.triangle_count(), 10U);
}

TEST(InputHandler, IsCalledInPlaceOfTheException) {
  StripMesh mesh = sample::octahedron();
  for (unsigned side = 0; side < 3; ++side) mesh.set_solid(StripMesh::halfedge(0, side), true);
  try {
    EXPECT_EQ(count_strips(mesh), 0U);
    FAIL() << "nothing thrown";
  } catch (const std::string& sentence) {
    EXPECT_EQ(sentence, "restrip: the colouring is not valid: a triangle has three solid dual edges");
  }
}

}  // namespace
}  // namespace restrip
