// Claims: the record of a collapse names the two vertices and the apexes on their sides, and its spokes split the mesh
// back to what it was, inside a mesh and on its boundary.
#include "restrip/mesh/split_record.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "restrip/mesh/checks.hpp"

namespace restrip {
namespace {

using Corners = std::array<Vertex, 3>;

/// A sheet of 4 × 4 squares; vertex 5 y + x.
std::vector<Corners> sheet() {
  std::vector<Corners> all;
  for (Vertex v = 0; v < 20; ++v) {
    if (v % 5 == 4) continue;
    all.push_back({v, v + 1, v + 6});
    all.push_back({v, v + 6, v + 5});
  }
  return all;
}
std::vector<Corners> sorted_triangles(const StripMesh& mesh) {
  std::vector<Corners> all;
  for (Triangle t = 0; t < mesh.triangle_bound(); ++t) {
    if (!mesh.alive(t)) continue;
    Corners corners = mesh.corners(t);
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    all.push_back(corners);
  }
  std::sort(all.begin(), all.end());
  return all;
}

TEST(SplitRecord, NamesTheApexesOnTheirSides) {
  const StripMesh mesh = StripMesh::build(sheet(), 25);
  EXPECT_EQ(record_of_collapse(mesh, mesh.spoke(6, 12)), (SplitRecord{6, 12, 11, 7}));
  EXPECT_EQ(record_of_collapse(mesh, mesh.spoke(1, 2)), (SplitRecord{1, 2, 7, none}));
  EXPECT_EQ(record_of_collapse(mesh, mesh.opposite(mesh.spoke(1, 2))), (SplitRecord{2, 1, none, 7}));
  EXPECT_EQ((SplitRecord{6, 12, 11, 7}).triangles(), 2U);
  EXPECT_EQ((SplitRecord{1, 2, 7, none}).triangles(), 1U);
  EXPECT_EQ((SplitRecord{2, 1, none, 7}).triangles(), 1U);
}

TEST(SplitRecord, SplitsBackWhatCollapsed) {
  const StripMesh whole = StripMesh::build(sheet(), 25);
  std::size_t done = 0;
  for (Triangle t = 0; t < whole.triangle_bound(); ++t)
    for (unsigned side = 0; side < 3; ++side)
      for (const auto chord : {StripMesh::halfedge(t, side), whole.opposite(StripMesh::halfedge(t, side))}) {
        if (check_collapse(whole, chord) != Refusal::granted) continue;
        StripMesh mesh = whole;
        const SplitRecord record = record_of_collapse(mesh, chord);
        mesh.remove_vertex(chord);
        ASSERT_EQ(mesh.triangle_count() + record.triangles(), whole.triangle_count());
        const auto where = spokes_of(mesh, record);
        ASSERT_EQ(check_split(mesh, where, record.v_t), Refusal::granted);
        mesh.insert_vertex(where, record.v_t);
        EXPECT_EQ(sorted_triangles(mesh), sorted_triangles(whole));
        ++done;
      }
  EXPECT_GT(done, 60U);
}

}  // namespace
}  // namespace restrip
