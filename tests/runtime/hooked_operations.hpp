// Operations done in two halves around a change of the mesh, on one of two equal meshes; the other one has them done by
// the library's functions.
#pragma once

#include <gtest/gtest.h>

#include <random>
#include <utility>
#include <vector>

#include "random_operation.hpp"
#include "restrip/mesh/checks.hpp"
#include "restrip/operations/hooks.hpp"
#include "restrip/output/strips.hpp"
#include "restrip/search/stripify.hpp"
#include "sample_meshes.hpp"

namespace restrip::hooked {

using Spoke = StripMesh::Halfedge;

inline void expect_same_colors(const StripMesh& one, const StripMesh& two) {
  ASSERT_EQ(sample::sides_of(one), sample::sides_of(two));
  ASSERT_EQ(sample::colors_of(one), sample::colors_of(two));
}

inline void expect_same(const Rewrite<Spoke>& one, const Rewrite<Spoke>& two) {
  EXPECT_EQ(one.halfedge, two.halfedge);
  EXPECT_EQ(one.valence, two.valence);
  EXPECT_EQ(one.strips, two.strips);
  EXPECT_EQ(one.isolated, two.isolated);
}

inline Rewrite<Spoke> hooked_collapse(StripMesh& mesh, Spoke chord) {
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

inline Rewrite<Spoke> hooked_split(StripMesh& mesh, const VertexSplit<Spoke>& where) {
  auto pending = before_split(mesh, where);
  EXPECT_TRUE(check_coloring(mesh).valid);
  auto moved = std::move(pending);
  EXPECT_TRUE(moved.waits());
  const Spoke chord = mesh.insert_vertex(where);
  return after_split(mesh, std::move(moved), chord);
}

inline Rewrite<Spoke> hooked_flip(StripMesh& mesh, Spoke h) {
  auto pending = before_flip(mesh, h);
  EXPECT_TRUE(check_coloring(mesh).valid);
  EXPECT_FALSE(mesh.solid(h));
  const Spoke turned = mesh.turn_edge(h);
  return after_flip(mesh, std::move(pending), turned);
}

inline void expect_what_operations_give() {
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

}  // namespace restrip::hooked
