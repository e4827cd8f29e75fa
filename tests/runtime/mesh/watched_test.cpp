// A watched mesh names every triangle that changes, for every kind of change.
#include "restrip/mesh/watched.hpp"

#include <gtest/gtest.h>

#include <random>

#include "restrip/operations/test_adapter.hpp"
#include "restrip/output/check_buffer.hpp"
#include "restrip/search/keeper.hpp"
#include "sample_meshes.hpp"

namespace restrip {
namespace {

TEST(Watched, NamesEveryChange) {
  for (StripMesh mesh : {sample::torus(7, 6), sample::rectangle(6, 5)}) {
    Watched watched(mesh);
    const AdapterReport report = test_adapter(watched, StripMesh::halfedge(0), &watched.changed());
    EXPECT_TRUE(report.kept()) << describe(report.broken) << " (" << report.during << ")";
  }
}

/// Forgets the neighbours of an edge that is turned.
struct Forgetful : Watched<StripMesh> {
  using Watched::Watched;
  Halfedge turn_edge(Halfedge h) {
    const std::size_t before = changed().size();
    const Halfedge turned = Watched::turn_edge(h);
    changed().resize(before + 1);
    return turned;
  }
};

TEST(Watched, AListThatForgetsIsFound) {
  StripMesh mesh = sample::torus(7, 6);
  Forgetful forgetful(mesh);
  const AdapterReport report = test_adapter(forgetful, StripMesh::halfedge(0), &forgetful.changed());
  EXPECT_EQ(report.broken, Contract::changes_named);
  EXPECT_STREQ(report.during, "turn_edge");
}

TEST(Watched, KeepsABufferInStepUnderAKeeper) {
  StripMesh mesh = sample::torus(12, 10);
  Watched watched(mesh);
  Keeper keeper(watched, Policy::quick, Cost::strips());
  StripBuffer buffer(watched);
  TriangleListBuffer list(watched);
  std::mt19937 random(2);
  for (int n = 0; n < 600; ++n) {
    const StripMesh::Halfedge h = StripMesh::halfedge(static_cast<Triangle>(random() % mesh.triangle_bound()));
    if (!mesh.alive(h)) continue;
    if (check_flip(mesh, h) == Refusal::granted && n % 3 == 0) keeper.flip(h);
    if (check_collapse(mesh, h) == Refusal::granted && n % 3 == 1 && mesh.triangle_count() > 100) keeper.collapse(h);
    if (check_split_face(mesh, h) == Refusal::granted && n % 3 == 2) keeper.split_face(h);
    buffer.update(watched, watched.changed());
    list.update(watched, watched.changed());
    watched.changed().clear();
    ASSERT_TRUE(check_buffer(buffer, watched).right());
    ASSERT_TRUE(check_buffer(list, watched).right());
  }
}

}  // namespace
}  // namespace restrip
