// A buffer that missed a change is detected, with the number of triangles.
#include "runtime/check_buffer.hpp"

#include <gtest/gtest.h>

#include "restrip/mesh/checks.hpp"
#include "restrip/search/stripify.hpp"
#include "runtime/sample_meshes.hpp"

namespace restrip {
namespace {

TEST(CheckBuffer, CountsWhatIsMissingAndExtra) {
  for (StripMesh& mesh : sample::meshes()) {
    stripify(mesh, Effort::fast, Cost::strips());
    LiveBuffer strips;
    LiveBuffer strips32({.form = StripForm::stitched, .width = IndexWidth::bits32});
    LiveBuffer list({.form = StripForm::list});
    for (LiveBuffer* const buffer : {&strips, &strips32, &list}) buffer->rebuild(mesh);
    EXPECT_TRUE(check_buffer(strips, mesh).right());
    EXPECT_TRUE(check_buffer(strips32, mesh).right());
    EXPECT_TRUE(check_buffer(list, mesh).right());
    StripMesh::Halfedge h{};
    for (Triangle t = 0; t < mesh.triangle_bound() && h.id == none; ++t)
      if (check_flip(mesh, StripMesh::halfedge(t)) == Refusal::granted) h = StripMesh::halfedge(t);
    if (h.id == none) continue;
    mesh.turn_edge(h);
    for (const BufferReport report : {check_buffer(strips, mesh), check_buffer(list, mesh)}) {
      EXPECT_EQ(report.missing, 2U);
      EXPECT_EQ(report.extra, 2U);
    }
  }
}

TEST(CheckBuffer, ATriangleTwiceIsOneTooMany) {
  const std::vector<std::uint16_t> indices{0, 1, 2, 3, 0xFFFF, 2, 1, 3, 3, 0xFFFF, 1, 2, 0};
  const auto drawn = triangles_of_strips(std::span<const std::uint16_t>(indices));
  EXPECT_EQ(drawn, (std::vector<DrawnTriangle>{{0, 1, 2}, {0, 1, 2}, {1, 3, 2}, {1, 3, 2}}));
}

}  // namespace
}  // namespace restrip
