// The halves of operations around a change of somebody else's: they give what split(), collapse() and flip() give on a
// second mesh, and those by linked rules what split_and_link(), collapse_and_link() and flip_and_link() give, colour by
// colour and in what they tell, on closed and open meshes, for fans of any size; between the halves, and so after a
// change that was given up, the colouring is valid.
#include <gtest/gtest.h>

#include <cstddef>
#include <random>
#include <utility>
#include <vector>

#include "restrip/mesh/checks.hpp"
#include "restrip/operations/linked_hooks.hpp"
#include "restrip/output/strips.hpp"
#include "restrip/search/stripify.hpp"
#include "sample_meshes.hpp"

namespace restrip {
namespace {

using Spoke = StripMesh::Halfedge;
using Spokes = VertexSplit<Spoke>::Spokes;

void expect_same_colors(const StripMesh& one, const StripMesh& two) {
  ASSERT_EQ(one.triangle_bound(), two.triangle_bound());
  for (Triangle t = 0; t < one.triangle_bound(); ++t) {
    ASSERT_EQ(one.alive(t), two.alive(t));
    for (unsigned s = 0; s < 3 && one.alive(t); ++s)
      ASSERT_EQ(one.solid(StripMesh::halfedge(t, s)), two.solid(StripMesh::halfedge(t, s)));
  }
}

void expect_same(const Rewrite<Spoke>& one, const Rewrite<Spoke>& two) {
  EXPECT_EQ(one.halfedge, two.halfedge);
  EXPECT_EQ(one.valence, two.valence);
  EXPECT_EQ(one.strips, two.strips);
  EXPECT_EQ(one.isolated, two.isolated);
}

Rewrite<Spoke> hooked_collapse(StripMesh& mesh, Spoke chord, HookRules rules = HookRules::local) {
  const Spoke back = mesh.opposite(chord);
  const Vertex v_s = mesh.from(chord);
  std::vector<Vertex> apexes;
  for (const Spoke h : {chord, back})
    if (!StripMesh::on_boundary(h)) apexes.push_back(mesh.to(StripMesh::next(h)));
  auto pending = before_collapse(mesh, chord, rules);
  EXPECT_TRUE(check_coloring(mesh).valid);
  const Spoke spoke = mesh.remove_vertex(chord);
  for (const Vertex apex : apexes)  // a colour that only after_collapse() can take away
    if (const Spoke merged = mesh.spoke(v_s, apex);
        !StripMesh::on_boundary(merged) && !StripMesh::on_boundary(mesh.opposite(merged)))
      mesh.set_solid(merged, true);
  return after_collapse(mesh, std::move(pending), spoke, rules);
}

Rewrite<Spoke> hooked_split(StripMesh& mesh, const VertexSplit<Spoke>& where, HookRules rules = HookRules::local) {
  const bool linked = rules == HookRules::linked;
  auto pending = linked ? before_split_and_link(mesh, where) : before_split(mesh, where);
  EXPECT_TRUE(check_coloring(mesh).valid);
  auto moved = std::move(pending);
  EXPECT_TRUE(moved.waits());
  const Spoke chord = mesh.insert_vertex(where);
  return linked ? after_split_and_link(mesh, std::move(moved), chord) : after_split(mesh, std::move(moved), chord);
}

Rewrite<Spoke> hooked_flip(StripMesh& mesh, Spoke h, HookRules rules = HookRules::local) {
  auto pending = before_flip(mesh, h);
  EXPECT_TRUE(check_coloring(mesh).valid);
  EXPECT_FALSE(mesh.solid(h));
  const Spoke turned = mesh.turn_edge(h);
  return rules == HookRules::linked ? after_flip_and_link(mesh, std::move(pending), turned)
                                    : after_flip(mesh, std::move(pending), turned);
}

Spoke any_halfedge(const StripMesh& mesh, std::mt19937& random) {
  for (;;) {
    const auto t = static_cast<Triangle>(random() % mesh.triangle_bound());
    if (!mesh.alive(t)) continue;
    const Spoke h = StripMesh::halfedge(t, static_cast<unsigned>(random() % 3));
    return random() % 3 == 0 ? mesh.opposite(h) : h;
  }
}

/// Draws a split; the spokes that do not count are not to be looked at.
VertexSplit<Spoke> any_split(const StripMesh& mesh, std::mt19937& random) {
  VertexSplit<Spoke> where;
  where.left = where.right = any_halfedge(mesh, random);
  for (auto turns = 1 + random() % 5; turns > 0 && !StripMesh::on_boundary(where.right); --turns)
    where.right = turn_ccw(mesh, where.right);
  if (mesh.leaves_boundary(where.left) && random() % 2 == 0) {
    where.spokes = random() % 2 == 0 ? Spokes::left_only : Spokes::right_only;
    (where.spokes == Spokes::left_only ? where.right : where.left) = {};
  }
  return where;
}

void expect_what_operations_give(HookRules rules) {
  const bool linked = rules == HookRules::linked;
  unsigned seed = 0;
  for (StripMesh& start : sample::meshes()) {
    stripify(start);
    StripMesh one = start;
    StripMesh two = start;
    std::mt19937 random(++seed);
    std::size_t done = 0;
    for (int n = 0; n < 1500; ++n) {
      const bool grow = one.triangle_count() < start.triangle_count() + random() % 40;
      if (random() % 3 == 0) {
        const Spoke h = any_halfedge(one, random);
        if (check_flip(one, h) != Refusal::granted) continue;
        expect_same(hooked_flip(two, h, rules), linked ? flip_and_link(one, h) : flip(one, h));
      } else if (grow) {
        const auto where = any_split(one, random);
        if (check_split(one, where) != Refusal::granted) continue;
        expect_same(hooked_split(two, where, rules), linked ? split_and_link(one, where) : split(one, where));
      } else {
        const Spoke h = any_halfedge(one, random);
        if (check_collapse(one, h) != Refusal::granted) continue;
        expect_same(hooked_collapse(two, h, rules), linked ? collapse_and_link(one, h) : collapse(one, h));
      }
      ++done;
      expect_same_colors(one, two);
      if (testing::Test::HasFatalFailure()) return;
    }
    EXPECT_GT(done, 300U) << "mesh " << seed;
    EXPECT_TRUE(check_coloring(one).valid);
  }
}

TEST(Hooks, GiveWhatTheOperationsGive) { expect_what_operations_give(HookRules::local); }
TEST(Hooks, GiveWhatLinkedOperationsGive) { expect_what_operations_give(HookRules::linked); }

TEST(Hooks, FansOfAnySize) {
  for (const Vertex k : {15U, 16U, 17U, 63U, 64U, 65U, 200U}) {
    StripMesh one = sample::double_cone(k);
    stripify(one);
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

// As a library does of which one of two edges stays where they merge: that edge may come with any colour, also where it
// lies on the boundary then.
TEST(Hooks, MergedEdgesComeDashed) {
  for (StripMesh mesh : {sample::rectangle(9, 7), sample::torus(12, 9)}) {
    stripify(mesh);
    std::mt19937 random(5);
    std::size_t done = 0;
    for (int n = 0; n < 400; ++n) {
      const Spoke h = any_halfedge(mesh, random);
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
  stripify(mesh);
  const ColoringReport before = check_coloring(mesh);
  HookTally tally;
  std::mt19937 random(3);
  while (tally.operations < 40) {
    const Spoke h = any_halfedge(mesh, random);
    if (check_collapse(mesh, h) == Refusal::granted) tally.add(hooked_collapse(mesh, h));
  }
  const ColoringReport after = check_coloring(mesh);
  EXPECT_TRUE(after.valid);
  EXPECT_EQ(static_cast<long>(after.strips), static_cast<long>(before.strips) + tally.strips);
  EXPECT_EQ(static_cast<long>(after.isolated), static_cast<long>(before.isolated) + tally.isolated);
  EXPECT_EQ(tally.untold, 0U);
}

}  // namespace
}  // namespace restrip
