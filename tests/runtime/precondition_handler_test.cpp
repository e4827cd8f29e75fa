// A handler of the user's own takes the place of the abort, with NDEBUG as without it, and gets function and sentence.
#include <stdexcept>
#include <string>

inline void report(const char* function, const char* sentence) {
  throw std::logic_error(std::string(function) + ": " + sentence);
}
#define RESTRIP_ASSERT(condition, function, sentence) ((condition) ? static_cast<void>(0) : report(function, sentence))

#include <gtest/gtest.h>

#include "restrip/operations/operations.hpp"
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

}  // namespace
}  // namespace restrip
