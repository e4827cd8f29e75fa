// A broken precondition in a debug build is named: the function, and the sentence of describe().
//
// Built without NDEBUG in every preset. Each public entry is refused, in a process that must abort with the sentence on
// its standard error (each reason to refuse an operation: mesh/checks_test.cpp); and with a limit of a few triangles
// (RESTRIP_MAX_TRIANGLES) the mesh reports that it is full and does not change.
#ifdef NDEBUG
#error "build this test without NDEBUG"
#endif

#include "restrip/precondition.hpp"

#include <gtest/gtest.h>

#include <array>
#include <stdexcept>
#include <string>
#include <vector>

#include "output/strip_buffer.hpp"
#include "restrip/restrip.hpp"
#include "restrip/tables/operations/bisect.hpp"
#include "restrip/tables/operations/join_faces.hpp"
#include "restrip/tables/operations/split_face.hpp"
#include "sample_meshes.hpp"
#include "search/strip_locator.hpp"
#include "whole_mesh.hpp"

namespace restrip {
namespace {

using Halfedge = StripMesh::Halfedge;
using Where = VertexSplit;
using sample::Corners;

// What restrip writes before it aborts. The sentences contain no regex metacharacters.
#define EXPECT_REFUSED(statement, function, refusal) \
  EXPECT_DEATH(statement, std::string("restrip: ") + (function) + ": " + describe(Refusal::refusal))
#define EXPECT_FAILED(statement, text) EXPECT_DEATH(statement, text)

StripMesh build(const std::vector<Corners>& triangles, std::size_t vertices) {
  return StripMesh::build(triangles, vertices);
}
StripMesh tetrahedron() { return build({{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}}, 4); }
StripMesh two_triangles() { return build({{0, 1, 2}, {0, 2, 3}}, 4); }

TEST(PreconditionDeathTest, AMissingSpoke) {
  StripMesh mesh = sample::octahedron();
  ASSERT_EQ(mesh.spoke(4, 5).id, none);
  EXPECT_REFUSED(split(mesh, {mesh.spoke(4, 0), mesh.spoke(4, 5)}), "split", no_such_edge);
  EXPECT_REFUSED(split(mesh, {mesh.spoke(4, 0), mesh.spoke(4, 9)}), "split", no_such_edge);
}

TEST(PreconditionDeathTest, ADeadHandle) {
  StripMesh mesh = sample::rectangle(3, 3);
  const Halfedge dead = mesh.spoke(5, 6);
  ASSERT_EQ(check_collapse(mesh, dead), Refusal::granted);
  collapse(mesh, dead);
  EXPECT_REFUSED(collapse(mesh, dead), "collapse", no_such_edge);
  EXPECT_REFUSED(flip(mesh, dead), "flip", no_such_edge);
  EXPECT_REFUSED(split(mesh, {dead, mesh.spoke(5)}), "split", no_such_edge);
  EXPECT_REFUSED((void)mesh.opposite(dead), "StripMesh::opposite", no_such_edge);
  EXPECT_REFUSED((void)mesh.from(dead), "StripMesh::from", no_such_edge);
  EXPECT_REFUSED((void)mesh.to(dead), "StripMesh::to", no_such_edge);
  EXPECT_REFUSED((void)mesh.solid(dead), "StripMesh::solid", no_such_edge);
  EXPECT_REFUSED((void)mesh.fan_step(dead), "StripMesh::fan_step", no_such_edge);
  EXPECT_REFUSED(mesh.set_solid(dead, true), "StripMesh::set_solid", no_such_edge);
}

TEST(PreconditionDeathTest, EveryWayOfDoingAnOperation) {
  StripMesh mesh = sample::octahedron();
  const Where same{mesh.spoke(4), mesh.spoke(4)};
  EXPECT_REFUSED(split_baked(mesh, same, {}), "split_baked", same_spoke);
  EXPECT_REFUSED(mesh.insert_vertex(same), "StripMesh::insert_vertex", same_spoke);
  EXPECT_REFUSED(collapse_baked(mesh, {}, {}), "collapse_baked", no_such_edge);
  EXPECT_REFUSED(mesh.remove_vertex({}), "StripMesh::remove_vertex", no_such_edge);
  EXPECT_REFUSED(mesh.turn_edge({}), "StripMesh::turn_edge", no_such_edge);
  for (const Policy policy : {Policy::local, Policy::quick}) {
    Keeper keeper(mesh, policy, Cost::strips());
    EXPECT_REFUSED(keeper.split(same), "Keeper::split", same_spoke);
    EXPECT_REFUSED(keeper.split({mesh.spoke(4, 0), mesh.spoke(4, 1)}, 2U), "Keeper::split", vertex_in_use);
    EXPECT_REFUSED(keeper.collapse({}), "Keeper::collapse", no_such_edge);
    EXPECT_REFUSED(keeper.flip({}), "Keeper::flip", no_such_edge);
  }
  const std::array<Halfedge, 1> dead{Halfedge{}};
  EXPECT_REFUSED(split_baked(mesh, {mesh.spoke(4, 0), mesh.spoke(4, 1)}, dead), "flips of a baked record",
                 no_such_edge);
}

TEST(PreconditionDeathTest, CustomOperations) {
  StripMesh mesh = sample::rectangle(3, 3);
  Halfedge inside = StripMesh::halfedge(0);
  while (!StripMesh::on_boundary(mesh.opposite(inside))) inside = StripMesh::next(inside);
  const Halfedge rim = mesh.opposite(inside);
  EXPECT_REFUSED(apply(mesh, tables::split_face_rules, {none}), "apply", no_such_edge);
  EXPECT_REFUSED(apply(mesh, tables::split_face_rules, rim), "apply", boundary_edge);
  EXPECT_REFUSED(apply(mesh, tables::bisect_rules, inside), "apply", other_patch);
  StripMesh pointed = tetrahedron();
  EXPECT_REFUSED(apply(pointed, tables::join_faces_rules, StripMesh::halfedge(0)), "apply", too_few_triangles);
  Keeper keeper(mesh, Policy::quick, Cost::strips());
  EXPECT_REFUSED(keeper.apply(tables::bisect_rules, inside), "Keeper::apply", other_patch);
  // A triangle replaced twice, and one without room for its handle.
  std::array<Triangle, 1> made{};
  const std::array<Triangle, 2> out{0, 0};
  const std::array<std::array<Vertex, 3>, 1> in{mesh.corners(0)};
  EXPECT_REFUSED(mesh.replace(out, in, made), "StripMesh::replace", other_patch);
  EXPECT_FAILED(mesh.replace(std::span(out).first(1), in, std::span<Triangle>()),
                "StripMesh::replace: `made` must have one element for each new triangle");
}

TEST(PreconditionDeathTest, EveryLookAtAMesh) {
  StripMesh mesh = two_triangles();
  EXPECT_FAILED((void)mesh.spoke(4), "StripMesh::spoke: the vertex is not one of this mesh");
  EXPECT_FAILED((void)mesh.spoke(none, 0), "StripMesh::spoke: the vertex is not one of this mesh");
  EXPECT_FAILED((void)mesh.non_manifold(4), "StripMesh::non_manifold: the vertex is not one of this mesh");
  EXPECT_FAILED((void)mesh.corners(2), "StripMesh::corners: the triangle is not one of this mesh");
  EXPECT_FAILED((void)mesh.solid_degree(2), "StripMesh::solid_degree: the triangle is not one of this mesh");
  EXPECT_FAILED((void)mesh.solid_sides(2), "StripMesh::solid_sides: the triangle is not one of this mesh");
  EXPECT_REFUSED(mesh.set_solid(mesh.spoke(0, 1), true), "StripMesh::set_solid", boundary_edge);
  EXPECT_REFUSED(mesh.set_solid(mesh.opposite(mesh.spoke(0, 1)), true), "StripMesh::set_solid", boundary_edge);
  EXPECT_REFUSED((void)mesh.fan_step(mesh.spoke(0, 3)), "StripMesh::fan_step", boundary_edge);
}

TEST(PreconditionDeathTest, StripsThatAreOutOfDate) {
  StripMesh mesh = sample::rectangle(3, 3);
  stripify(mesh, Effort::fast, Cost::strips());
  const Strips strips = extract_strips(mesh);
  Halfedge solid = StripMesh::halfedge(strips.order[0], 0);
  while (!mesh.solid(solid)) solid = StripMesh::next(solid);
  mesh.set_solid(solid, false);
  EXPECT_FAILED((void)strip_indices(mesh, strips), "strip_indices: these are not the strips of the mesh as it is now");
  EXPECT_FAILED((void)strip_index_count(mesh, strips), "strip_index_count: these are not the strips of the mesh");
}

TEST(PreconditionDeathTest, RoomForTheNeighborsOfAList) {
  const std::vector<Corners> list{{0, 1, 4}};
  std::vector<std::array<std::uint32_t, 3>> across(2);
  BuildReport report;
  EXPECT_FAILED(find_neighbors(TriangleList(list), 9, across, report),
                "find_neighbors: `across` must have one element for each triangle");
}

TEST(PreconditionDeathTest, TheLocatorOfStrips) {
  StripMesh mesh = two_triangles();
  StripLocator locator(mesh);
  const Halfedge inside = mesh.spoke(0, 2);
  EXPECT_FAILED((void)locator.position(7), "StripLocator::position: the locator does not know the triangle");
  EXPECT_FAILED(locator.cut(mesh, inside), "StripLocator::cut: the dual edge is dashed already");
  locator.link(mesh, inside);
  EXPECT_FAILED(locator.link(mesh, inside), "StripLocator::link: the dual edge is solid already");
  // Around vertex 3, three triangles in a row: the edge that is left would close the ring.
  StripMesh cone = build({{0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {0, 2, 4}}, 5);
  StripLocator of_cone(cone);
  of_cone.link(cone, cone.spoke(3, 1));
  of_cone.link(cone, cone.spoke(3, 2));
  EXPECT_FAILED(of_cone.link(cone, cone.spoke(3, 0)),
                "StripLocator::link: the dual edge joins the two ends of one strip");
  StripMesh row = build({{0, 1, 2}, {2, 1, 3}, {2, 3, 4}, {1, 5, 3}}, 6);
  StripLocator of_row(row);
  of_row.link(row, row.spoke(1, 2));
  of_row.link(row, row.spoke(2, 3));
  EXPECT_FAILED(of_row.link(row, row.spoke(1, 3)),
                "StripLocator::link: a triangle at the dual edge is not the end of a strip");
}

TEST(PreconditionDeathTest, EveryLookUp) {
  const std::string split_position = "the position is out of range: 3 <= k <= max_word_valence, 1 <= a < k";
  for (const SplitPosition at : {SplitPosition{4, 0}, {4, 4}, {2, 1}, {62, 3}}) {
    EXPECT_FAILED((void)split_rule(at, 0, 0), "restrip: split_rule: " + split_position);
    EXPECT_FAILED((void)collapse_rule(at, 0, 0), "restrip: collapse_rule: " + split_position);
  }
  for (const GapPair at : {GapPair{4, 2, 2}, {4, 3, 5}}) {
    EXPECT_FAILED((void)open_split_rule(at, 0, 0), "path_with_chord: the position is out of range: i < j <= k");
    EXPECT_FAILED((void)open_collapse_rule(at, 0, 0), "path_with_chord: the position is out of range: i < j <= k");
  }
  EXPECT_FAILED((void)open_split_rule({62, 1, 2}, 0, 0), "Patch::valid: k is out of range");
  EXPECT_FAILED((void)boundary_split_rule({4, 5}, 0, 0), "path: the position is out of range");
  EXPECT_FAILED((void)boundary_collapse_rule({4, 5}, 0, 0), "path: the position is out of range");
  EXPECT_FAILED((void)boundary_collapse_rule({62, 1}, 0, 0), "Patch::valid: k is out of range");
  EXPECT_FAILED((void)ring_with_chord(4, 0), "ring_with_chord: the position is out of range: 1 <= a < k");
  EXPECT_FAILED((void)ring_with_chord(4, 4), "ring_with_chord: the position is out of range: 1 <= a < k");
  EXPECT_FAILED((void)path(0, 0), "path: the position is out of range");
  EXPECT_FAILED((void)closed_fan(0), "closed_fan: k is out of range: 1 <= k");
  EXPECT_FAILED((void)open_fan(0), "open_fan: k is out of range: 1 <= k");
  EXPECT_FAILED((void)exact::best(closed_fan(62), 0, 0), "exact::best: k is out of range");
  EXPECT_FAILED((void)closed_fan(62).joined(0, 0), "Patch::joined: k is out of range");
}

// With the checks, the look-ups still keep their promises.
static_assert(noexcept(split_rule({4, 2}, 0, 0)) && split_rule({4, 2}, 0, 0).valid);
static_assert(noexcept(flip_rule(false, 0)) && flip_rule(false, 0).valid);
static_assert(noexcept(exact::best(ring_with_chord(12, 5), 0, 0)) &&
              exact::best(ring_with_chord(12, 5), 0, 0).value.solid == 13);
static_assert(noexcept(closed_fan(5).valid(0, 0)) && closed_fan(5).valid(0, 0));

// ---- errors of every build

// Built with RESTRIP_MAX_TRIANGLES = 40.
TEST(StripMeshLimit, AFullMeshSaysSoAndStaysAsItIs) {
  ASSERT_EQ(StripMesh::max_triangles, 40U);
  const std::vector<Corners> grid = sample::grid(5, 4, false, false, 1);
  ASSERT_EQ(grid.size(), 40U);
  std::vector<Corners> more = grid;
  more.push_back({0, 1, 30});
  EXPECT_THROW((void)StripMesh::build(more, 31), std::length_error);
  StripMesh mesh = StripMesh::build(grid, 30);
  stripify(mesh, Effort::fast, Cost::strips());
  const StripMesh before = mesh;
  const Where where{mesh.spoke(7), turn_ccw(mesh, mesh.spoke(7))};
  EXPECT_THROW(split(mesh, where), std::length_error);
  const Where one_sided{mesh.spoke(0), {}, Where::Spokes::left_only};
  EXPECT_THROW(split(mesh, one_sided), std::length_error);
  EXPECT_THROW(apply(mesh, tables::split_face_rules, mesh.spoke(7)), std::length_error);
  EXPECT_EQ(mesh.triangle_count(), 40U);
  EXPECT_TRUE(differing_triangles(mesh, before).empty());
  // Handles that a collapse frees can be taken again; one free triangle is not enough for two.
  const Halfedge edge = mesh.spoke(0, 1);
  ASSERT_EQ(check_collapse(mesh, edge), Refusal::granted);
  collapse(mesh, edge);
  ASSERT_EQ(mesh.triangle_count(), 39U);
  const Where inside{mesh.spoke(14), turn_ccw(mesh, mesh.spoke(14))};
  EXPECT_THROW(split(mesh, inside), std::length_error);
  EXPECT_EQ(mesh.triangle_count(), 39U);
  split(mesh, {mesh.spoke(0), {}, Where::Spokes::left_only});
  EXPECT_EQ(mesh.triangle_count(), 40U);
  EXPECT_TRUE(check_coloring(mesh).valid);
}

}  // namespace
}  // namespace restrip
