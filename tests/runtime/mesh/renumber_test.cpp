// A mesh whose triangles have other handles goes through the same operations as the mesh that it was copied from: what
// has handle t there has handles[t] here, with its corners, neighbours, colours and first spokes, and so have triangles
// that are inserted later, up to the bound and beyond it.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <vector>

#include "random_operation.hpp"
#include "restrip/mesh/checks.hpp"
#include "restrip/operations/operations.hpp"
#include "restrip/search/stripify.hpp"
#include "sample_meshes.hpp"

namespace restrip {
namespace {

using Halfedge = StripMesh::Halfedge;

TEST(Renumbering, TrianglesGoTheSameWay) {
  for (const unsigned seed : {1U, 2U, 3U}) {
    std::mt19937 random(seed);
    StripMesh plain = seed == 3 ? StripMesh::build(sample::grid(6, 5, false, false, seed), 42) : sample::sphere(2);
    stripify(plain);
    for (int collapses = 0; collapses < 5;) {  // some handles are free
      const Halfedge h = random_halfedge(plain, random);
      if (check_collapse(plain, h) != Refusal::granted) continue;
      collapse(plain, h);
      ++collapses;
    }
    std::vector<Triangle> handles(plain.triangle_bound() + 7);
    std::iota(handles.begin(), handles.end(), Triangle{0});
    std::shuffle(handles.begin(), handles.end(), random);
    StripMesh other = plain;
    other.renumber(handles);
    EXPECT_EQ(other.triangle_bound(), handles.size());
    const auto renamed = [&](Halfedge h) {
      const Triangle t = StripMesh::triangle(h);
      return Halfedge{h.id == none || t >= handles.size() ? h.id : (h.id & ~(t << 2)) | handles[t] << 2};
    };
    for (int operations = 0; operations < 400;) {
      ASSERT_EQ(other.triangle_count(), plain.triangle_count());
      for (Triangle t = 0; t < plain.triangle_bound(); ++t) {
        const Triangle u = StripMesh::triangle(renamed(StripMesh::halfedge(t)));
        ASSERT_EQ(other.alive(u), plain.alive(t));
        if (!plain.alive(t)) continue;
        ASSERT_EQ(other.corners(u), plain.corners(t));
        ASSERT_EQ(other.solid_sides(u), plain.solid_sides(t));
        for (unsigned side = 0; side < 3; ++side)
          ASSERT_EQ(other.opposite(StripMesh::halfedge(u, side)),
                    renamed(plain.opposite(StripMesh::halfedge(t, side))));
      }
      for (Vertex v = 0; v < plain.vertex_bound(); ++v) ASSERT_EQ(other.spoke(v), renamed(plain.spoke(v)));
      const Halfedge h = random_halfedge(plain, random);
      const VertexSplit<Halfedge> where{h, turn_ccw(plain, h), VertexSplit<Halfedge>::Spokes::both};
      const auto kind = random() % 5;
      if (kind < 3 && check_split(plain, where) == Refusal::granted) {
        ASSERT_EQ(split(other, {renamed(where.left), renamed(where.right), where.spokes}).halfedge,
                  renamed(split(plain, where).halfedge));
      } else if (kind == 3 && check_collapse(plain, h) == Refusal::granted) {
        ASSERT_EQ(collapse(other, renamed(h)).strips, collapse(plain, h).strips);
      } else if (kind == 4 && check_flip(plain, h) == Refusal::granted) {
        ASSERT_EQ(flip(other, renamed(h)).strips, flip(plain, h).strips);
      } else {
        continue;
      }
      ++operations;
    }
    EXPECT_GT(plain.triangle_bound(), handles.size());
  }
}

}  // namespace
}  // namespace restrip
