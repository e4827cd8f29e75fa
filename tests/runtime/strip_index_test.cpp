// The index says of every triangle what walking its strip says, after any mixture of cuts, links and local rewrites.
#include "restrip/search/strip_index.hpp"

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "index_agrees.hpp"
#include "random_operation.hpp"
#include "restrip/mesh/checks.hpp"
#include "restrip/mesh/walks.hpp"
#include "restrip/operations/operations.hpp"
#include "restrip/output/strips.hpp"
#include "restrip/search/stripify.hpp"
#include "sample_meshes.hpp"

namespace restrip {
namespace {

using Halfedge = StripMesh::Halfedge;

void random_cut_or_link(StripIndex& index, StripMesh& mesh, std::mt19937& random) {
  const Halfedge h = random_halfedge(mesh, random);
  const Halfedge g = mesh.opposite(h);
  if (StripMesh::on_boundary(g)) return;
  if (mesh.solid(h)) {
    if (random() % 4 == 0) index.cut(mesh, h);
    return;
  }
  const Triangle a = StripMesh::triangle(h);
  const Triangle b = StripMesh::triangle(g);
  if (mesh.solid_degree(a) > 1 || mesh.solid_degree(b) > 1) return;
  if (index.position(a).strip != index.position(b).strip) index.link(mesh, h);
}

void random_operation(StripIndex& index, StripMesh& mesh, std::mt19937& random, bool grow) {
  std::vector<Triangle> patch;
  const Halfedge h = random_halfedge(mesh, random);
  const unsigned kind = static_cast<unsigned>(random() % 5);
  if (kind == 0) {
    if (check_flip(mesh, h) != Refusal::granted) return;
    patch = {StripMesh::triangle(h), StripMesh::triangle(mesh.opposite(h))};
    index.before_patch(mesh, patch);
    flip(mesh, h);
    index.after_patch(mesh, patch);
  } else if (!grow) {
    if (check_collapse(mesh, h) != Refusal::granted) return;
    edge_triangles(mesh, h, patch);
    index.before_patch(mesh, patch);
    const auto done = collapse(mesh, h);
    fan_triangles(mesh, done.halfedge, patch);
    index.after_patch(mesh, patch);
  } else {
    using Spokes = VertexSplit<Halfedge>::Spokes;
    VertexSplit<Halfedge> where{h, h, Spokes::both};
    for (int turns = 1 + static_cast<int>(random() % 4); turns > 0; --turns)
      if (!StripMesh::on_boundary(where.right)) where.right = turn_ccw(mesh, where.right);
    if (mesh.leaves_boundary(h) && random() % 2 == 0)
      where.spokes = random() % 2 == 0 ? Spokes::left_only : Spokes::right_only;
    if (where.spokes == Spokes::right_only && StripMesh::on_boundary(where.right)) return;
    if (check_split(mesh, where) != Refusal::granted) return;
    fan_triangles(mesh, h, patch);
    index.before_patch(mesh, patch);
    const auto done = split(mesh, where);
    edge_triangles(mesh, done.halfedge, patch);
    index.after_patch(mesh, patch);
  }
}

// Chunks of all sizes: many small ones, the usual ones, and one for every strip.
class StripIndexOf : public ::testing::TestWithParam<std::uint32_t> {};
INSTANTIATE_TEST_SUITE_P(ChunkLimits, StripIndexOf, ::testing::Values(8, StripIndex::default_chunk_limit, 1024));

TEST_P(StripIndexOf, AgreesAfterCutsAndLinks) {
  std::mt19937 random(3);
  for (StripMesh& mesh : sample::meshes()) {
    stripify(mesh);
    StripIndex index(mesh, GetParam());
    ASSERT_TRUE(agrees(index, mesh));
    for (int i = 0; i < 2000; ++i) {
      random_cut_or_link(index, mesh, random);
      if (i % 20 == 0) {
        ASSERT_TRUE(agrees(index, mesh)) << i;
      }
    }
    ASSERT_TRUE(check_coloring(mesh).valid);
  }
}

TEST_P(StripIndexOf, AgreesAfterRewrites) {
  std::mt19937 random(4);
  for (StripMesh& mesh : sample::meshes()) {
    stripify(mesh);
    StripIndex index(mesh, GetParam());
    for (int i = 0; i < 3000; ++i) {
      random_operation(index, mesh, random, mesh.triangle_count() < 40 || (i / 300) % 2 == 0);
      if (i % 25 == 0) {
        ASSERT_TRUE(agrees(index, mesh)) << i;
      }
    }
    ASSERT_TRUE(check_coloring(mesh).valid);
  }
}

TEST_P(StripIndexOf, AgreesOnALargeMeshAfterEverything) {
  std::mt19937 random(5);
  StripMesh mesh = sample::torus(90, 70);
  stripify(mesh);
  StripIndex index(mesh, GetParam());
  for (int i = 0; i < 60000; ++i) {
    if (random() % 3 != 0)
      random_cut_or_link(index, mesh, random);
    else
      random_operation(index, mesh, random, (i / 5000) % 2 == 0);
    if (i % 1500 == 0) {
      ASSERT_TRUE(agrees(index, mesh)) << i;
    }
  }
  ASSERT_TRUE(agrees(index, mesh));
  ASSERT_TRUE(check_coloring(mesh).valid);
}

}  // namespace
}  // namespace restrip
