// A watched mesh names every triangle that changes, for every kind of change. Buffers that are kept by its list are in
// tests/adapters.
#include "restrip/mesh/watched.hpp"

#include <gtest/gtest.h>

#include "restrip/operations/test_adapter.hpp"
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

}  // namespace
}  // namespace restrip
