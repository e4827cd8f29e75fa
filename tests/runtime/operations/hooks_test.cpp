// The halves of operations around a change by other code: they give what split(), collapse() and flip() give on a
// second mesh, colour by colour and in their reports, on closed and open meshes, for fans of any size; between the
// halves, and so after a change that was abandoned, the colouring is valid.
#include "restrip/operations/hooks.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <random>
#include <utility>
#include <vector>

#include "random_operation.hpp"
#include "restrip/mesh/checks.hpp"
#include "restrip/output/strips.hpp"
#include "restrip/search/stripify.hpp"
#include "sample_meshes.hpp"

namespace restrip {
namespace {

using Spoke = StripMesh::Halfedge;

void expect_same_colors(const StripMesh& one, const StripMesh& two) {
  ASSERT_EQ(sample::sides_of(one), sample::sides_of(two));
  ASSERT_EQ(sample::colors_of(one), sample::colors_of(two));
}

void expect_same(const Rewrite<Spoke>& one, const Rewrite<Spoke>& two) {
  EXPECT_EQ(one.halfedge, two.halfedge);
  EXPECT_EQ(one.valence, two.valence);
  EXPECT_EQ(one.strips, two.strips);
  EXPECT_EQ(one.isolated, two.isolated);
}

Rewrite<Spoke> hooked_collapse(StripMesh& mesh, Spoke chord) {
  const Spoke back = mesh.opposite(chord);
  const Vertex v_s = mesh.from(chord);
  std::vector<Vertex> apexes;
  for (const Spoke h : {chord, back})
    if (!StripMesh::on_boundary(h)) apexes.push_back(mesh.to(StripMesh::next(h)));
  auto pending = before_collapse(mesh, chord);
  EXPECT_TRUE(check_coloring(mesh).valid);
  const Spoke spoke = mesh.remove_vertex(chord);
  for (const Vertex apex : apexes)  // a colour that only after_collapse() can take away
    if (const Spoke merged = mesh.spoke(v_s, apex);
        !StripMesh::on_boundary(merged) && !StripMesh::on_boundary(mesh.opposite(merged)))
      mesh.set_solid(merged, true);
  return after_collapse(mesh, std::move(pending), spoke);
}

Rewrite<Spoke> hooked_split(StripMesh& mesh, const VertexSplit<Spoke>& where) {
  auto pending = before_split(mesh, where);
  EXPECT_TRUE(check_coloring(mesh).valid);
  auto moved = std::move(pending);
  EXPECT_TRUE(moved.waits());
  const Spoke chord = mesh.insert_vertex(where);
  return after_split(mesh, std::move(moved), chord);
}

Rewrite<Spoke> hooked_flip(StripMesh& mesh, Spoke h) {
  auto pending = before_flip(mesh, h);
  EXPECT_TRUE(check_coloring(mesh).valid);
  EXPECT_FALSE(mesh.solid(h));
  const Spoke turned = mesh.turn_edge(h);
  return after_flip(mesh, std::move(pending), turned);
}

TEST(Hooks, GiveWhatTheOperationsGive) {
  unsigned seed = 0;
  for (StripMesh& start : sample::meshes()) {
    stripify(start, Effort::fast, Cost::strips());
    StripMesh one = start;
    StripMesh two = start;
    std::mt19937 random(++seed);
    std::size_t done = 0;
    for (int n = 0; n < 1500; ++n) {
      const bool grow = one.triangle_count() < start.triangle_count() + random() % 40;
      const DrawnOperation drawn =
          draw_at(one, random_side(one, random), random, splits_collapses_flips, trend_of(grow));
      const Checked granted = perform(one, drawn);
      if (!granted) continue;
      expect_same(drawn.kind == OperationKind::flip       ? hooked_flip(two, drawn.h)
                  : drawn.kind == OperationKind::collapse ? hooked_collapse(two, drawn.h)
                                                          : hooked_split(two, drawn.where),
                  granted.rewrite);
      ++done;
      expect_same_colors(one, two);
      if (testing::Test::HasFatalFailure()) return;
    }
    EXPECT_GT(done, 300U) << "mesh " << seed;
    EXPECT_TRUE(check_coloring(one).valid);
  }
}

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
