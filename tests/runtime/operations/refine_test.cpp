// split_face, bisect and their inverses: they make the mesh that they promise, on a bare list of triangles; the
// colouring stays valid, and the reported changes of strips and isolated triangles are what a census of the whole mesh
// finds, mixed with splits, collapses and flips, on closed and open meshes; each undoes the other; their checks refuse
// other patches.
#include "restrip/operations/refine.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <set>

#include "../../support/sanitizers.hpp"
#include "random_operation.hpp"
#include "restrip/mesh/checks.hpp"
#include "restrip/output/strips.hpp"
#include "sample_meshes.hpp"
#include "triangle_list.hpp"

namespace restrip {
namespace {

using Halfedge = StripMesh::Halfedge;

/// The bare list after an operation that puts `added` between the corners from and to of one triangle, or of an edge.
bare::List refined_list(const bare::List& list, OperationKind kind, Vertex from, Vertex to, Vertex apex, Vertex added) {
  bare::List result;
  for (const auto& c : list) {
    const auto has = [&](Vertex v) { return std::find(c.begin(), c.end(), v) != c.end(); };
    const bool whole = has(from) && has(to) && has(apex);
    if (kind == OperationKind::split_face ? !whole : !has(from) || !has(to)) {
      result.push_back(c);
      continue;
    }
    for (std::size_t i = 0; i < 3; ++i) {
      if (kind == OperationKind::bisect && c[i] != from && c[i] != to) continue;
      bare::Corners part = c;
      part[i] = added;
      result.push_back(part);
    }
  }
  return bare::sorted(result);
}

class RefineWalk {
 public:
  RefineWalk(StripMesh start, unsigned seed) : mesh_(std::move(start)), random_(seed) {}

  void run(std::size_t operations) {
    const std::size_t size = mesh_.triangle_count();
    reported_ = census_of(mesh_);
    for (done_ = 0; done_ < operations && !::testing::Test::HasFailure();) {
      const bool grow = mesh_.triangle_count() < size / 2 || (mesh_.triangle_count() < 2 * size && random_() % 2 == 0);
      const Halfedge h = random_side(mesh_, random_);
      const bool did = random_() % 3 == 0 ? others(h, grow) : ours(h, grow);
      done_ += did ? 1 : 0;
      if (did && done_ % 32 == 0) {
        EXPECT_EQ(census_of(mesh_), reported_);
      }
    }
    EXPECT_EQ(census_of(mesh_), reported_);
  }

  std::map<OperationKind, std::size_t> granted;

 private:
  bool ours(Halfedge h, bool grow) {
    const auto [kind, at, unused] = draw_at(mesh_, h, random_, refinements, trend_of(grow));
    const bool look = random_() % 16 == 0;
    const bare::List before = look ? sample::triangles_of(mesh_) : bare::List{};
    const Vertex from = mesh_.from(h);
    const Vertex to = mesh_.to(h);
    const Vertex apex = StripMesh::on_boundary(h) ? none : mesh_.to(StripMesh::next(h));
    const Checked done = perform(mesh_, {kind, h, {}});
    if (look && !done) {
      EXPECT_EQ(sample::triangles_of(mesh_), before);
    }
    if (!done) return false;
    ++granted[kind];
    reported_ += done.rewrite;
    const Halfedge made = done.rewrite.halfedge;
    EXPECT_EQ(mesh_.from(made), from);
    if (!look) return true;
    if (grow) {
      EXPECT_EQ(sample::triangles_of(mesh_), refined_list(before, kind, from, to, apex, mesh_.to(made)));
    } else if (kind == OperationKind::merge) {
      EXPECT_EQ(before,
                refined_list(sample::triangles_of(mesh_), OperationKind::bisect, from, mesh_.to(made), none, to));
    } else {
      const Halfedge inside = StripMesh::next(mesh_.opposite(made));
      EXPECT_EQ(before, refined_list(sample::triangles_of(mesh_), OperationKind::split_face, from, mesh_.to(made),
                                     mesh_.to(inside), to));
    }
    return true;
  }

  bool others(Halfedge h, bool grow) {
    const Checked done = perform(mesh_, draw_at(mesh_, h, random_, splits_collapses_flips, trend_of(grow)));
    if (done) reported_ += done.rewrite;
    return done.granted();
  }

  StripMesh mesh_;
  std::mt19937 random_;
  std::size_t done_ = 0;
  Census reported_;
};

TEST(Refine, ReportsWhatItChangedInAMillionOperations) {
  std::map<OperationKind, std::size_t> granted;
  unsigned seed = 1;
  for (const StripMesh& start : sample::meshes()) {
    RefineWalk walk(start, seed++);
    walk.run(test::large(160'000));
    for (const auto& [kind, times] : walk.granted) granted[kind] += times;
  }
  for (const auto& [kind, share] : refinements) EXPECT_GT(granted[kind], 4000U);
}

TEST(Refine, InversesUndoEachOther) {
  for (const StripMesh& start : sample::meshes())
    for (Triangle t = 0; t < start.triangle_bound(); ++t)
      for (unsigned side = 0; side < 6; ++side) {
        const Halfedge there = StripMesh::halfedge(t, side % 3);
        const Halfedge h = side < 3 ? there : start.opposite(there);
        for (const auto& [forth, back] : {std::pair{OperationKind::split_face, OperationKind::join_faces},
                                          {OperationKind::bisect, OperationKind::merge}}) {
          StripMesh mesh = start;
          const Checked done = perform(mesh, {forth, h, {}});
          if (!done) continue;
          EXPECT_EQ(done.rewrite.valence, forth == OperationKind::split_face ? 3U
                                          : StripMesh::on_boundary(h) || StripMesh::on_boundary(start.opposite(h))
                                              ? 2U
                                              : 4U);
          const Checked undone = perform(mesh, {back, done.rewrite.halfedge, {}});
          ASSERT_TRUE(undone) << describe(undone.refusal);
          EXPECT_EQ(sample::triangles_of(mesh), sample::triangles_of(start));
          EXPECT_TRUE(check_coloring(mesh).valid);
          if (forth == OperationKind::bisect) {
            EXPECT_EQ(mesh.from(undone.rewrite.halfedge), start.from(h));
            EXPECT_EQ(mesh.to(undone.rewrite.halfedge), start.to(h));
          }
        }
      }
}

// Exactly the triangles that the operation removes must lie around v_t.
TEST(Refine, RefusesOtherValences) {
  const StripMesh sphere = sample::sphere(1);
  std::set<std::size_t> seen;
  for (Vertex v = 0; v < sphere.vertex_bound(); ++v) {
    const std::size_t valence = spoke_count(sphere, v);
    const Halfedge chord = sphere.opposite(sphere.spoke(v));
    seen.insert(valence);
    EXPECT_EQ(check_merge(sphere, chord), valence == 4 ? Refusal::granted : Refusal::other_valence);
    EXPECT_EQ(check_join_faces(sphere, chord), Refusal::other_valence);
  }
  EXPECT_EQ(seen, (std::set<std::size_t>{4, 6}));
  const StripMesh rectangle = sample::rectangle(4, 3);
  const Halfedge outside = rectangle.opposite(rectangle.spoke(0));
  const Halfedge rim = StripMesh::on_boundary(outside) ? outside : rectangle.opposite(outside);
  EXPECT_EQ(check_split_face(rectangle, {none}), Refusal::no_such_edge);
  EXPECT_EQ(check_bisect(rectangle, {none}), Refusal::no_such_edge);
  EXPECT_EQ(check_merge(rectangle, {none}), Refusal::no_such_edge);
  EXPECT_EQ(check_join_faces(rectangle, {none}), Refusal::no_such_edge);
  ASSERT_TRUE(StripMesh::on_boundary(rim));
  EXPECT_EQ(check_split_face(rectangle, rim), Refusal::boundary_edge);
  EXPECT_EQ(check_bisect(rectangle, rim), Refusal::granted);
}

// The facts of the tables, from the certificates' claims: refining costs a strip at most, and inside a face none.
// Two triangles that share two sides. The checks of the mesh are asked, although refine.hpp is read before checks.hpp.
TEST(Refine, RefusesBetweenOneSpokeAndItself) {
  const StripMesh mesh = StripMesh::build(std::vector<std::uint32_t>{0, 1, 2, 1, 0, 2}, 3);
  EXPECT_EQ(check_bisect(mesh, StripMesh::halfedge(1, 0)), Refusal::same_spoke);
}

TEST(Refine, RefiningIsolatesNothing) {
  std::mt19937 random(7);
  StripMesh mesh = sample::torus(12, 9);
  int most = 0;
  for (int n = 0; n < 2000; ++n) {
    const Halfedge h = StripMesh::halfedge(static_cast<Triangle>(random() % mesh.triangle_count()), 0);
    const bool face = random() % 2 == 0;
    const auto done = face ? split_face(mesh, h) : bisect(mesh, h);
    EXPECT_LE(done.isolated, 0);
    EXPECT_LE(done.strips, face ? 0 : 1);
    most = std::max(most, done.strips);
  }
  EXPECT_EQ(most, 1);
}

}  // namespace
}  // namespace restrip
