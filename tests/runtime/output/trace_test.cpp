// A trace is what docs/reference/file-formats.md shows. That a reader can follow the mesh from it, and judge each
// operation: tests/verify/check.
#include "restrip/output/trace.hpp"

#include <gtest/gtest.h>

#include <array>
#include <vector>

namespace restrip {
namespace {

// docs/reference/file-formats.md shows this one.
TEST(Trace, IsWhatTheDocumentShows) {
  StripMesh mesh = StripMesh::build(std::vector<std::array<Vertex, 3>>{{0, 1, 2}, {2, 1, 3}, {2, 3, 4}}, 5);
  std::vector<Triangle> changed;
  mesh.watch(&changed);
  mesh.set_solid(mesh.spoke(1, 2), true);
  Trace trace(mesh, Trace::Claim::best);
  changed.clear();
  mesh.set_solid(mesh.spoke(2, 3), true);
  trace.add(mesh, changed, {Traced::Kind::other, 0, 0, -1, -1});
  changed.clear();
  mesh.set_solid(mesh.spoke(2, 3), false);
  mesh.turn_edge(mesh.spoke(2, 3));
  mesh.set_solid(mesh.spoke(1, 4), true);
  trace.add(mesh, changed, {Traced::Kind::flip, 2, 3, 0, 0});
  trace.end();
  EXPECT_EQ(trace.text(),
            "restrip-trace 1\n"
            "claim best\n"
            "t 0 1 2\n"
            "t 1 3 2\n"
            "t 2 3 4\n"
            "s 1 2\n"
            "other 0 0 -1 -1 s 2 3\n"
            "flip 2 3 0 0 - 1 3 2 2 3 4 + 1 3 4 1 4 2 d 2 3 s 1 4\n"
            "end 2\n");
}

}  // namespace
}  // namespace restrip
