// apply() does what an operation file says: on a StripMesh the triangles are those that are worked out on a bare list;
// its check grants just the operations that leave the mesh as good; strips and isolated triangles change as reported;
// and if a shipped function does the same operation, mesh and colours are the same. Keepers and other meshes:
// apply_kept_test.cpp.
#include "restrip/operations/apply.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>
#include <utility>
#include <vector>

#include "../../support/sanitizers.hpp"
#include "applied_lists.hpp"
#include "own_operations.hpp"
#include "restrip/operations/refine.hpp"
#include "restrip/output/strips.hpp"
#include "restrip/search/stripify.hpp"
#include "sample_meshes.hpp"
#include "triangle_list.hpp"

namespace restrip {
namespace {

using Halfedge = StripMesh::Halfedge;

static_assert(SurfaceTable<std::remove_const_t<decltype(tables::refine_face_rules)>>);
static_assert(!SurfaceTable<tables::OperationTable<std::uint8_t, 8>>, "a graph has no triangles");

// At every halfedge of small meshes, among them such with vertices of two and three triangles and non-manifold ones.
TEST(Apply, DoesWhatTheFileSaysWhereItMay) {
  std::vector<StripMesh> meshes{sample::octahedron(),        sample::rectangle(4, 3), sample::tube(4, 4),
                                sample::torus(4, 5),         sample::sphere(1),       sample::double_cone(3),
                                sample::open_double_cone(3), sample::tetrahedron()};
  meshes.push_back(StripMesh::build(std::vector<bare::Corners>{{0, 1, 2}, {0, 2, 3}, {0, 3, 1}}, 4));
  meshes.push_back(StripMesh::build(std::vector<bare::Corners>{{0, 1, 2}, {2, 1, 3}, {4, 5, 0}, {0, 6, 4}}, 7));
  // Vertices of three triangles, and of two on the boundary.
  for (const auto& [mesh, t] : {std::pair{sample::torus(4, 5), 3U}, {sample::rectangle(4, 3), 2U}}) {
    meshes.push_back(mesh);
    apply(meshes.back(), tables::split_face_rules, StripMesh::halfedge(t));
    apply(meshes.back(), tables::split_face_rules, StripMesh::halfedge(t));
    for (Triangle u = 0; u < mesh.triangle_bound(); ++u)
      checked_apply(meshes.back(), tables::bisect_boundary_rules, StripMesh::halfedge(u, 1));
    checked_apply(meshes.back(), tables::bisect_rules, StripMesh::halfedge(0));
    meshes.back().clear_colors();  // pairs are wanted as well as strips
  }
  for_each_applicable([&](const char* name, const auto& table) {
    std::size_t granted = 0;
    for (const StripMesh& mesh : meshes)
      granted += try_everywhere(
          mesh, [&](Halfedge) -> const auto& { return table; });
    EXPECT_GT(granted, 5U) << name;
    for (const StripMesh& mesh : sample::meshes())
      for (Triangle t = 0; t < mesh.triangle_bound(); ++t) {
        StripMesh copy = mesh;
        if (checked_apply(copy, table, StripMesh::halfedge(t))) {
          EXPECT_EQ(fault_of(copy), "") << name;
        }
      }
  });
}

TEST(Apply, ReportsWhatItChanged) {
  std::mt19937 random(5);
  std::size_t done = 0;
  for (StripMesh& mesh : sample::meshes()) {
    stripify(mesh, Effort::fast, Cost::strips());
    Census reported = census_of(mesh);
    const std::size_t size = 3 * mesh.triangle_count() + 20;
    for (std::size_t n = 0; n < test::large(20'000); ++n) {
      reported += stir(mesh, mesh, random, size).rewrite;
      if (!random_application(mesh, random, size, [&](const auto& table, Halfedge h) {
            const auto rewrite = apply(mesh, table, h);
            EXPECT_EQ(rewrite.valence, table.ports);
            reported += rewrite;
          }))
        continue;
      ++done;
      if (n % 64 != 0) continue;
      ASSERT_EQ(census_of(mesh), reported);
    }
    ASSERT_EQ(census_of(mesh), reported);
    EXPECT_EQ(fault_of(mesh), "");
  }
  EXPECT_GT(done, test::large(20'000) / 5);
}

// The mesh, the colours and the handles of the operation are the same as by the shipped functions.
TEST(Apply, DoesWhatTheShippedFunctionsDo) {
  std::mt19937 random(6);
  std::array<std::size_t, 6> compared{};
  const auto compare = [&](const StripMesh& start, std::size_t kind, const auto& table, Halfedge where,
                           auto&& shipped) {
    StripMesh by_function = start;
    StripMesh by_table = start;
    const auto wanted = shipped(by_function);
    const auto done = checked_apply(by_table, table, where);
    ASSERT_TRUE(done) << describe(done.refusal);
    EXPECT_EQ(sample::triangles_of(by_table), sample::triangles_of(by_function));
    EXPECT_EQ(solid_edges_of(by_table), solid_edges_of(by_function));
    EXPECT_EQ(done.rewrite.strips, wanted.strips);
    EXPECT_EQ(done.rewrite.isolated, wanted.isolated);
    EXPECT_EQ(done.rewrite.valence, wanted.valence);
    ++compared[kind];
  };
  for (const StripMesh& start : {sample::torus(6, 5), sample::rectangle(5, 4), sample::tube(5, 6)}) {
    StripMesh mesh = start;
    stripify(mesh, Effort::fast, Cost::strips());
    for (std::size_t n = 0; n < 2000; ++n) {
      stir(mesh, mesh, random, 3 * start.triangle_count());
      random_application(mesh, random, 3 * start.triangle_count(),
                         [&](const auto& table, Halfedge h) { apply(mesh, table, h); });
      const Halfedge h = random_halfedge(mesh, random);
      const Halfedge g = mesh.opposite(h);
      const auto split = [&](StripMesh& m) { return split_face(m, h); };
      const auto bisected = [&](StripMesh& m) { return bisect(m, h); };
      const auto joined = [&](StripMesh& m) { return join_faces(m, g); };
      const auto merged = [&](StripMesh& m) { return merge(m, g); };
      if (check_split_face(mesh, h) == Refusal::granted) compare(mesh, 0, tables::split_face_rules, h, split);
      if (check_join_faces(mesh, g) == Refusal::granted) compare(mesh, 1, tables::join_faces_rules, h, joined);
      if (check_bisect(mesh, h) == Refusal::granted) {
        if (StripMesh::on_boundary(g))
          compare(mesh, 2, tables::bisect_boundary_rules, h, bisected);
        else
          compare(mesh, 3, tables::bisect_rules, h, bisected);
      }
      if (check_merge(mesh, g) != Refusal::granted) continue;
      // h leaves the vertex to be removed.
      if (StripMesh::on_boundary(g))
        compare(mesh, 4, tables::merge_boundary_rules, h, merged);
      else if (!mesh.leaves_boundary(h))
        compare(mesh, 5, tables::merge_rules, detail::first_around(mesh, g), merged);
      if (HasFatalFailure()) return;
    }
  }
  for (const std::size_t times : compared) EXPECT_GT(times, 10U);
}

// The halves, for code that changes the mesh itself.
TEST(Apply, InTwoHalves) {
  StripMesh mesh = sample::torus(6, 6);
  stripify(mesh, Effort::fast, Cost::strips());
  for (Triangle t = 0; t < 60; ++t) {
    StripMesh other = mesh;
    const Halfedge h = StripMesh::halfedge(t, t % 3);
    const auto pending = before_apply(other, tables::split_face_rules, h);
    EXPECT_EQ(pending.patch().side[0][0], h);
    EXPECT_TRUE(check_coloring(other).valid);
    const Halfedge chord = other.insert_vertex(detail::split_into_face(other, h));
    const auto reported = after_apply(other, pending, StripMesh::next(other.opposite(chord)));
    const auto done = split_face(mesh, h);
    EXPECT_EQ(reported.strips, done.strips);
    EXPECT_EQ(solid_edges_of(other), solid_edges_of(mesh));
  }
}

// Coarsening and refining again gives the same handles.
TEST(Apply, TakesBackTheHandlesThatItGave) {
  StripMesh mesh = sample::torus(5, 5);
  const Halfedge h = StripMesh::halfedge(7, 1);
  const Halfedge first = apply(mesh, tables::split_face_rules, h).halfedge;
  const std::vector<bare::Corners> refined = sample::triangles_of(mesh);
  const std::size_t bound = mesh.triangle_bound();
  const Halfedge apex = mesh.next(mesh.next(first));  // m -> a
  const auto joined = apply(mesh, tables::join_faces_rules, apex);
  EXPECT_EQ(mesh.triangle_count(), 50U);
  EXPECT_EQ(StripMesh::triangle(joined.halfedge), StripMesh::triangle(apex));
  apply(mesh, tables::split_face_rules, joined.halfedge);
  EXPECT_EQ(sample::triangles_of(mesh), refined);
  EXPECT_EQ(mesh.triangle_bound(), bound);
}

// An operation with a border side fits in at most one orientation of a triangle. A brute-force count of the sheet knows
// where: at corners with two triangles, seen from the side that leads from the corner into the mesh.
TEST(Apply, AnywhereFindsTheOrientationThatFits) {
  std::mt19937 random(3);
  std::size_t one_way = 0;
  std::size_t any_way = 0;
  for (int round = 0; round < 100; ++round) {
    StripMesh mesh = sample::rectangle(6, 5, static_cast<unsigned>(round));
    stripify(mesh);
    for (Triangle t = 0; t < mesh.triangle_bound(); ++t) {
      std::vector<Halfedge> fitting;
      for (unsigned s = 0; s < 3; ++s) {
        // `m b c`, with m b on the boundary, m of two triangles, and `a m c` next to it across m c.
        const Halfedge h = StripMesh::halfedge(t, s);
        const Halfedge beyond = mesh.opposite(StripMesh::next(StripMesh::next(h)));
        const bool is_rim = StripMesh::on_boundary(mesh.opposite(h)) && !StripMesh::on_boundary(beyond);
        if (is_rim && StripMesh::on_boundary(mesh.opposite(StripMesh::next(StripMesh::next(beyond)))) &&
            check_apply(mesh, tables::merge_boundary_rules, h) == Refusal::granted)
          fitting.push_back(h);
      }
      const Places found = places(mesh, tables::merge_boundary_rules, t);
      ASSERT_TRUE(std::equal(found.begin(), found.end(), fitting.begin(), fitting.end()));
    }
    const auto t = static_cast<Triangle>(random() % mesh.triangle_bound());
    one_way += check_apply(mesh, tables::merge_boundary_rules, StripMesh::halfedge(t)) == Refusal::granted ? 1U : 0U;
    const bool fits = !places(mesh, tables::merge_boundary_rules, t).empty();
    const std::size_t before = mesh.triangle_count();
    const Checked done = apply_anywhere(mesh, tables::merge_boundary_rules, t);
    ASSERT_EQ(done.granted(), fits);
    ASSERT_EQ(mesh.triangle_count(), before - (fits ? 1 : 0));
    ASSERT_TRUE(check_coloring(mesh).valid);
    any_way += fits ? 1U : 0U;
  }
  EXPECT_GT(any_way, 2 * one_way);
  StripMesh torus = sample::torus(5, 5);
  EXPECT_EQ(places(torus, tables::split_face_rules, 7).size(), 3U);
  EXPECT_TRUE(places(torus, tables::merge_boundary_rules, 7).empty());
  EXPECT_EQ(apply_anywhere(torus, tables::merge_boundary_rules, 7).refusal, Refusal::other_patch);
  EXPECT_TRUE(places(torus, tables::split_face_rules, 50).empty());
  EXPECT_EQ(apply_anywhere(torus, tables::split_face_rules, 50).refusal, Refusal::no_such_edge);
}

TEST(Apply, RefusesWithAReason) {
  const StripMesh rectangle = sample::rectangle(4, 3);
  EXPECT_EQ(check_apply(rectangle, tables::split_face_rules, {none}), Refusal::no_such_edge);
  Halfedge rim = StripMesh::halfedge(0);
  while (!StripMesh::on_boundary(rectangle.opposite(rim))) rim = StripMesh::next(rim);
  EXPECT_EQ(check_apply(rectangle, tables::split_face_rules, rectangle.opposite(rim)), Refusal::boundary_edge);
  EXPECT_EQ(check_apply(rectangle, tables::bisect_rules, rim), Refusal::other_patch);
  EXPECT_EQ(check_apply(rectangle, tables::bisect_boundary_rules, rim), Refusal::granted);
  EXPECT_EQ(check_apply(sample::torus(5, 5), tables::bisect_boundary_rules, StripMesh::halfedge(0)),
            Refusal::other_patch);
  EXPECT_EQ(check_apply(sample::octahedron(), tables::join_faces_rules, StripMesh::halfedge(0)), Refusal::other_patch);
  const StripMesh tetrahedron = sample::tetrahedron();
  EXPECT_EQ(check_apply(tetrahedron, tables::join_faces_rules, StripMesh::halfedge(0)), Refusal::too_few_triangles);
  EXPECT_EQ(check_apply(tetrahedron, tables::flip_matching_rules, StripMesh::halfedge(0)), Refusal::edge_exists);
  EXPECT_EQ(check_apply(sample::meshes().back(), tables::split_face_rules, StripMesh::halfedge(0)),
            Refusal::non_manifold_vertex);
  StripMesh bad = sample::torus(5, 5);
  for (unsigned s = 0; s < 3; ++s) bad.set_solid(StripMesh::halfedge(0, s), true);
  EXPECT_EQ(check_apply(bad, tables::split_face_rules, StripMesh::halfedge(0)), Refusal::colors_not_valid);
}

}  // namespace
}  // namespace restrip
