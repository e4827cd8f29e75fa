// The locator agrees with a walk along the strip for every triangle, after any mixture of cuts, links and local
// rewrites.
#include "search/strip_locator.hpp"

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "random_operations.hpp"
#include "restrip/mesh/checks.hpp"
#include "restrip/mesh/walks.hpp"
#include "restrip/operations/operations.hpp"
#include "restrip/output/strips.hpp"
#include "restrip/search/stripify.hpp"
#include "sample_meshes.hpp"
#include "whole_mesh.hpp"

namespace restrip {
namespace {

using Halfedge = StripMesh::Halfedge;

void random_cut_or_link(StripLocator& locator, StripMesh& mesh, std::mt19937& random) {
  const Halfedge h = random_halfedge(mesh, random);
  const Halfedge g = mesh.opposite(h);
  if (StripMesh::on_boundary(g)) return;
  if (mesh.solid(h)) {
    if (random() % 4 == 0) locator.cut(mesh, h);
    return;
  }
  const Triangle a = StripMesh::triangle(h);
  const Triangle b = StripMesh::triangle(g);
  if (mesh.solid_degree(a) > 1 || mesh.solid_degree(b) > 1) return;
  if (locator.position(a).strip != locator.position(b).strip) locator.link(mesh, h);
}

constexpr auto mostly_splits =
    std::to_array<OperationShare>({{OperationKind::flip}, {OperationKind::split, 4}, {OperationKind::collapse, 4}});

void operation_at(StripLocator& locator, StripMesh& mesh, Halfedge h, std::mt19937& random, bool grow) {
  const DrawnOperation drawn = draw_at(mesh, h, random, mostly_splits, trend_of(grow));
  if (check(mesh, drawn) != Refusal::granted) return;
  const bool splits = drawn.kind == OperationKind::split;
  const auto triangles_at = [&mesh](bool fan, Halfedge at) {
    std::vector<Triangle> patch;
    fan ? fan_triangles(mesh, at, patch) : edge_triangles(mesh, at, patch);
    return patch;
  };
  if (drawn.kind == OperationKind::flip) {
    const std::vector<Triangle> patch{StripMesh::triangle(h), StripMesh::triangle(mesh.opposite(h))};
    locator.before_patch(mesh, patch);
    perform(mesh, drawn);
    locator.after_patch(mesh, patch);
    return;
  }
  locator.before_patch(mesh, triangles_at(splits, h));
  const Checked done = perform(mesh, drawn);
  locator.after_patch(mesh, triangles_at(!splits, done.rewrite.halfedge));
}

void random_operation(StripLocator& locator, StripMesh& mesh, std::mt19937& random, bool grow) {
  operation_at(locator, mesh, random_halfedge(mesh, random), random, grow);
}

TEST(StripLocator, AgreesOnALargeMeshAfterEverything) {
  std::mt19937 random(5);
  StripMesh mesh = sample::torus(90, 70);
  stripify(mesh, Effort::fast, Cost::strips());
  StripLocator locator(mesh);
  for (int i = 0; i < 60000; ++i) {
    if (random() % 3 != 0)
      random_cut_or_link(locator, mesh, random);
    else
      random_operation(locator, mesh, random, (i / 5000) % 2 == 0);
    if (i % 1500 == 0) {
      ASSERT_EQ(disagreement(locator, mesh), "") << i;
    }
  }
  ASSERT_EQ(disagreement(locator, mesh), "");
  ASSERT_TRUE(check_coloring(mesh).valid);
}

// A strip creeps round a ring of triangles, linked at one end and cut at the other; and back.
TEST(StripLocator, AgreesWhereAStripCreeps) {
  StripMesh mesh = sample::tube(6, 1);
  std::vector<Halfedge> ring;  // from each triangle to the next
  for (Halfedge h = StripMesh::halfedge(0, 0); ring.size() < mesh.triangle_count(); h = mesh.opposite(ring.back())) {
    do h = StripMesh::next(h);
    while (StripMesh::on_boundary(mesh.opposite(h)));
    ring.push_back(h);
  }
  StripLocator locator(mesh);
  constexpr std::size_t length = 5;
  constexpr std::size_t way = 2600;
  const auto dual_edge = [&](std::size_t i) { return ring[i % ring.size()]; };
  for (std::size_t i = 0; i < length; ++i) locator.link(mesh, dual_edge(i));
  for (std::size_t i = 0; i < way; ++i) {
    locator.link(mesh, dual_edge(i + length));
    locator.cut(mesh, dual_edge(i));
    ASSERT_EQ(disagreement(locator, mesh), "") << i;
  }
  for (std::size_t i = way; i-- > 0;) {
    locator.link(mesh, dual_edge(i));
    locator.cut(mesh, dual_edge(i + length));
    ASSERT_EQ(disagreement(locator, mesh), "") << i;
  }
}

}  // namespace
}  // namespace restrip
