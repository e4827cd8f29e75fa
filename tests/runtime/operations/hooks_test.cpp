// The halves of operations around a change by other code: they give what split(), collapse() and flip() give on a
// second mesh, colour by colour and in their reports, on closed and open meshes, for fans of any size; between the
// halves, and so after a change that was abandoned, the colouring is valid.
#include "restrip/operations/hooks.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <random>

#include "hooked_operations.hpp"
#include "restrip/mesh/checks.hpp"
#include "restrip/output/strips.hpp"
#include "restrip/search/stripify.hpp"
#include "sample_meshes.hpp"

namespace restrip {
namespace {

using namespace hooked;

TEST(Hooks, GiveWhatTheOperationsGive) { expect_what_operations_give(); }

TEST(Hooks, FansOfAnySize) {
  for (const Vertex k : {15U, 16U, 17U, 63U, 64U, 65U, 200U}) {
    StripMesh one = sample::double_cone(k);
    stripify(one, Effort::fast, Cost::strips());
    StripMesh two = one;
    Spoke right = one.spoke(0);
    for (Vertex i = 0; i < k / 3; ++i) right = turn_ccw(one, right);
    const VertexSplit<Spoke> where{one.spoke(0), right};
    const auto done = split(one, where);
    EXPECT_EQ(done.valence, k);
    expect_same(hooked_split(two, where), done);
    expect_same_colors(one, two);
    expect_same(hooked_collapse(two, done.halfedge), collapse(one, done.halfedge));
    expect_same_colors(one, two);
    if (HasFatalFailure()) return;
  }
}

// A library chooses which of two merged edges stays: that edge may have any colour, also if it then lies on the
// boundary.
TEST(Hooks, MergedEdgesAreDashed) {
  for (StripMesh mesh : {sample::rectangle(9, 7), sample::torus(12, 9)}) {
    stripify(mesh, Effort::fast, Cost::strips());
    std::mt19937 random(5);
    std::size_t done = 0;
    for (int n = 0; n < 400; ++n) {
      const Spoke h = random_side(mesh, random);
      if (check_collapse(mesh, h) != Refusal::granted) continue;
      StripMesh copy = mesh;
      const auto pending = before_collapse(copy, h);
      for (const Spoke inward : {h, copy.opposite(h)}) {
        if (StripMesh::on_boundary(inward)) continue;
        EXPECT_FALSE(copy.solid(inward));
        EXPECT_FALSE(copy.solid(StripMesh::next(inward)));
        EXPECT_FALSE(copy.solid(StripMesh::next(StripMesh::next(inward))));
      }
      EXPECT_TRUE(pending.waits());
      EXPECT_TRUE(check_coloring(copy).valid);
      ++done;
    }
    EXPECT_GT(done, 100U);
  }
}

TEST(Hooks, TallyAddsUp) {
  StripMesh mesh = sample::torus(12, 9);
  stripify(mesh, Effort::fast, Cost::strips());
  Census expected = census_of(mesh);
  HookTally tally;
  std::mt19937 random(3);
  while (tally.operations < 40) {
    const Spoke h = random_side(mesh, random);
    if (check_collapse(mesh, h) == Refusal::granted) tally.add(hooked_collapse(mesh, h));
  }
  EXPECT_EQ(census_of(mesh), expected += tally);
  EXPECT_EQ(tally.unannounced, 0U);
}

}  // namespace
}  // namespace restrip
