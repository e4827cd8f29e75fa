// Every function that reads a whole colouring refuses one that is not valid, with a sentence that says what is wrong.
#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

#include "restrip/mesh/walks.hpp"
#include "restrip/output/strips.hpp"
#include "restrip/search/keeper.hpp"
#include "sample_meshes.hpp"
#include "search/strip_locator.hpp"

namespace restrip {
namespace {

// A ring of solid edges lacks an end to locate a strip from, and a triangle of three solid edges is not part of a
// strip.
TEST(InvalidColorings, AreRefusedByReadersOfTheWholeMesh) {
  for (const bool cycle : {true, false}) {
    StripMesh mesh = sample::rectangle(3, 3);
    if (cycle) {
      for_each_spoke(mesh, 5, [&](StripMesh::Halfedge h) { mesh.set_solid(h, true); });
    } else {
      Triangle t = 0;
      const auto inner = [&](unsigned side) {
        return !StripMesh::on_boundary(mesh.opposite(StripMesh::halfedge(t, side)));
      };
      while (!inner(0) || !inner(1) || !inner(2)) ++t;
      for (unsigned side = 0; side < 3; ++side) mesh.set_solid(StripMesh::halfedge(t, side), true);
    }
    ASSERT_FALSE(check_coloring(mesh).valid);
    const auto message = [&](const auto& read) -> std::string {
      try {
        read();
      } catch (const std::invalid_argument& error) {
        return error.what();
      }
      return "nothing thrown";
    };
    const std::string expected = std::string("restrip: the colouring is not valid: ") +
                                 (cycle ? "solid dual edges close a cycle" : "a triangle has three solid dual edges");
    for (const Policy policy : {Policy::local, Policy::quick, Policy::full})
      EXPECT_EQ(message([&] { const Keeper keeper(mesh, policy, Cost::strips()); }), expected);
    EXPECT_EQ(message([&] { const StripLocator locator(mesh); }), expected);
    EXPECT_EQ(message([&] { (void)count_strips(mesh); }), expected);
    mesh.clear_colors();
    Keeper keeper(mesh, Policy::quick, Cost::strips());
    EXPECT_EQ(keeper.strips(), mesh.triangle_count());
    EXPECT_EQ(count_strips(mesh), mesh.triangle_count());
  }
}

}  // namespace
}  // namespace restrip
