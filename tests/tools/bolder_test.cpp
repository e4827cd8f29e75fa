// Claim: count_bolder says how often some recolouring of the patch, with the same ports, keeps more strips together in
// that mesh than the local rule. Here every recolouring is painted, and the whole mesh looked at after each.
#include "lod/bolder.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "common/disjoint_sets.hpp"
#include "lod/simplify.hpp"
#include "meshes/made_mesh.hpp"
#include "restrip/mesh/checks.hpp"
#include "restrip/operations/operations.hpp"
#include "restrip/search/stripify.hpp"

namespace restrip::tools {
namespace {

using Halfedge = StripMesh::Halfedge;

/// The number of strips, or 0 where the colouring is not valid.
std::size_t strips_if_valid(const StripMesh& mesh) {
  DisjointSets strips(mesh.triangle_bound());
  std::size_t count = mesh.triangle_count();
  for (Triangle t = 0; t < mesh.triangle_bound(); ++t) {
    if (!mesh.alive(t)) continue;
    if (mesh.solid_degree(t) > 2) return 0;
    for (unsigned side = 0; side < 3; ++side) {
      const Halfedge h = StripMesh::halfedge(t, side);
      if (!mesh.solid(h) || StripMesh::triangle(mesh.opposite(h)) < t) continue;
      if (!strips.unite(t, StripMesh::triangle(mesh.opposite(h)))) return 0;
      --count;
    }
  }
  return count;
}

/// The fewest strips that the mesh can have when nothing but these dual edges is recoloured.
std::size_t fewest_strips(StripMesh mesh, const std::vector<Halfedge>& inner) {
  std::size_t fewest = mesh.triangle_count();
  for (std::size_t colors = 0; colors < std::size_t{1} << inner.size(); ++colors) {
    for (std::size_t j = 0; j < inner.size(); ++j) mesh.set_solid(inner[j], (colors >> j & 1U) != 0);
    if (const std::size_t strips = strips_if_valid(mesh); strips != 0) fewest = std::min(fewest, strips);
  }
  return fewest;
}

void note(Boldness& counts, std::size_t before, std::size_t local, std::size_t best) {
  ++counts.operations;
  counts.costing += local > before ? 1 : 0;
  counts.costing_at_best += best > before ? 1 : 0;
  counts.bolder += best < local ? 1 : 0;
}

void expect_equal(const Boldness& told, const Boldness& counted) {
  EXPECT_EQ(told.operations, counted.operations);
  EXPECT_EQ(told.costing, counted.costing);
  EXPECT_EQ(told.costing_at_best, counted.costing_at_best);
  EXPECT_EQ(told.bolder, counted.bolder);
}

TEST(Bolder, EveryRecoloringOfEveryPatch) {
  const ProgressiveMesh source = simplify(make_mesh(300), {0.2, BoundaryPolicy::move}).mesh;
  StripMesh mesh = StripMesh::build(source.base, source.points.size());
  stripify(mesh);
  const BoldnessReport told = count_bolder(source, mesh);

  BoldnessReport counted;
  const auto spokes_around = [&](Vertex v, std::vector<Halfedge>& spokes) {
    for_each_spoke(mesh, v, [&](Halfedge h) { spokes.push_back(h); });
  };
  for (const Record& record : source.splits) {
    const std::size_t before = strips_if_valid(mesh);
    const auto done = split(mesh, spokes_of(mesh, record), record.v_t);
    if (done.valence > max_compared_valence) continue;
    std::vector<Halfedge> inner{done.halfedge};
    for (const Vertex v : {record.v_s, record.v_t}) {
      std::vector<Halfedge> spokes;
      spokes_around(v, spokes);
      for (const Halfedge h : spokes)
        if (mesh.to(h) != record.v_s && mesh.to(h) != record.v_t) inner.push_back(h);
    }
    ASSERT_EQ(inner.size(), done.valence + std::size_t{3});
    note(counted.splits, before, strips_if_valid(mesh), fewest_strips(mesh, inner));
  }
  for (auto record = source.splits.rbegin(); record != source.splits.rend(); ++record) {
    const std::size_t before = strips_if_valid(mesh);
    const auto done = collapse(mesh, mesh.spoke(record->v_s, record->v_t));
    if (done.valence > max_compared_valence) continue;
    std::vector<Halfedge> inner;
    spokes_around(record->v_s, inner);
    ASSERT_EQ(inner.size(), done.valence);
    note(counted.collapses, before, strips_if_valid(mesh), fewest_strips(mesh, inner));
  }
  expect_equal(told.splits, counted.splits);
  expect_equal(told.collapses, counted.collapses);
  EXPECT_GT(counted.splits.operations, 60U);
  EXPECT_GT(counted.splits.bolder, 0U);
  EXPECT_GT(counted.collapses.bolder, 0U);
}

}  // namespace
}  // namespace restrip::tools
