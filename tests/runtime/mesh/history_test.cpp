// Undo and redo restore the mesh exactly: triangles, handles, free handles and colours; for all operations and policies
// see output/live_buffer_test.cpp.
#include "mesh/history.hpp"

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "../../support/random_operations.hpp"
#include "sample_meshes.hpp"
#include "whole_mesh.hpp"

namespace restrip {
namespace {

// First spokes differ then, or the free handles, although every triangle is as it was.
TEST(History, AFrameThatSplitsAndCollapsesBackIsAFrame) {
  std::mt19937 random(7);
  std::size_t triangles_as_they_were = 0;
  for (const StripMesh& start : {sample::octahedron(), sample::rectangle(4, 4), sample::torus(5, 5)})
    for (int round = 0; round < 400; ++round) {
      StripMesh mesh = start;
      std::vector<Triangle> changed;
      mesh.watch(&changed);
      History history(mesh);
      std::vector<Look> looks{look_at(mesh)};
      for (int frame = 0; frame < 6; ++frame) {
        const auto triangles = sample::triangles_of(mesh);
        if (random() % 3 == 0)
          checked_flip(mesh, random_halfedge(mesh, random));
        else if (const Checked up = checked_split(mesh, random_split(mesh, random_halfedge(mesh, random), random)))
          if (random() % 4 != 0)
            checked_collapse(mesh, random() % 2 == 0 ? up.rewrite.halfedge : mesh.opposite(up.rewrite.halfedge));
        const Look look = look_at(mesh);
        const bool kept = history.frame(mesh, changed);
        changed.clear();
        ASSERT_TRUE(kept || look == looks.back());
        if (!kept) continue;
        if (!(look == looks.back()) && sample::triangles_of(mesh) == triangles) ++triangles_as_they_were;
        looks.push_back(look);
      }
      for (int steps = 0; steps < 12; ++steps) {
        const bool back = random() % 3 != 0;
        if (back ? history.undo(mesh) : history.redo(mesh)) {
          ASSERT_EQ(fault_of(mesh), "");
          ASSERT_EQ(look_at(mesh), looks[history.undoable()]);
        }
      }
      mesh.watch(nullptr);
    }
  EXPECT_GT(triangles_as_they_were, 100U);
}

TEST(History, ForgetsTrianglesThatCameAndWentInAFrame) {
  StripMesh mesh = sample::torus(5, 5);
  std::vector<Triangle> changed;
  mesh.watch(&changed);
  History history(mesh);
  const StripMesh::Halfedge h = StripMesh::halfedge(7);
  const auto bound = static_cast<Triangle>(mesh.triangle_bound());
  collapse(mesh, split(mesh, {h, turn_ccw(mesh, turn_ccw(mesh, h))}).halfedge);
  flip(mesh, StripMesh::halfedge(30));
  ASSERT_EQ(mesh.triangle_bound(), bound + 2);
  history.frame(mesh, changed);
  const Look look = look_at(mesh);
  ASSERT_TRUE(history.undo(mesh));
  ASSERT_TRUE(history.redo(mesh));
  EXPECT_FALSE(mesh.alive(bound) || mesh.alive(bound + 1));
  EXPECT_EQ(look_at(mesh), look);
}

}  // namespace
}  // namespace restrip
