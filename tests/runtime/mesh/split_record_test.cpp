// Claims: the record of a collapse names the two vertices and the apexes on their sides, and its spokes split the mesh
// back to what it was, inside a mesh and on its boundary.
#include "restrip/mesh/split_record.hpp"

#include <gtest/gtest.h>

#include "restrip/mesh/checks.hpp"
#include "sample_meshes.hpp"

namespace restrip {
namespace {

/// A sheet of 4 × 4 squares; vertex 5 y + x.
StripMesh four_squares() {
  return StripMesh::build(sample::sheet(4, 4, [](Vertex x, Vertex y) { return 5 * y + x; }), 25);
}

TEST(SplitRecord, NamesTheApexesOnTheirSides) {
  const StripMesh mesh = four_squares();
  EXPECT_EQ(record_of_collapse(mesh, mesh.spoke(6, 12)), (SplitRecord{6, 12, 11, 7}));
  EXPECT_EQ(record_of_collapse(mesh, mesh.spoke(1, 2)), (SplitRecord{1, 2, 7, none}));
  EXPECT_EQ(record_of_collapse(mesh, mesh.opposite(mesh.spoke(1, 2))), (SplitRecord{2, 1, none, 7}));
  EXPECT_EQ((SplitRecord{6, 12, 11, 7}).triangles(), 2U);
  EXPECT_EQ((SplitRecord{1, 2, 7, none}).triangles(), 1U);
  EXPECT_EQ((SplitRecord{2, 1, none, 7}).triangles(), 1U);
}

TEST(SplitRecord, SplitsBackWhatCollapsed) {
  const StripMesh whole = four_squares();
  std::size_t done = 0;
  for (const StripMesh::Halfedge h : sample::sides_of(whole))
    for (const auto chord : {h, whole.opposite(h)}) {
      if (check_collapse(whole, chord) != Refusal::granted) continue;
      StripMesh mesh = whole;
      const SplitRecord record = record_of_collapse(mesh, chord);
      mesh.remove_vertex(chord);
      ASSERT_EQ(mesh.triangle_count() + record.triangles(), whole.triangle_count());
      const auto where = spokes_of(mesh, record);
      ASSERT_EQ(check_split(mesh, where, record.v_t), Refusal::granted);
      mesh.insert_vertex(where, record.v_t);
      EXPECT_EQ(sample::triangles_of(mesh), sample::triangles_of(whole));
      ++done;
    }
  EXPECT_GT(done, 60U);
}

}  // namespace
}  // namespace restrip
