// From a list to strips without a mesh: the same indices as from a StripMesh, for every effort, cost and list.
#include "restrip/search/strips_of.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "form_reader.hpp"
#include "restrip/output/strips.hpp"
#include "restrip/search/stripify.hpp"
#include "sample_meshes.hpp"

namespace restrip {
namespace {

using sample::Corners;
using Indices = std::vector<std::uint32_t>;

/// Strips as strip_indices() has them, however long.
constexpr StripFormat plain{.width = IndexWidth::bits32, .list_if_shorter = false};

Indices by_way_of_a_mesh(const std::vector<Corners>& list, std::size_t vertices, Effort effort, Cost cost) {
  StripMesh mesh = StripMesh::build(list, vertices);
  stripify(mesh, effort, cost);
  return strip_indices(mesh);
}

TEST(StripsOf, AreTheStripsOfTheMesh) {
  for (const StripMesh& mesh : sample::meshes()) {
    const std::vector<Corners> list = sample::triangles_of(mesh);
    const std::size_t vertices = mesh.vertex_bound();
    for (const Cost cost : {Cost::indices(), Cost{100, 70, 1}, Cost::strips()})
      for (const Effort effort : {Effort::fast, Effort::full}) {
        const Indices expected = by_way_of_a_mesh(list, vertices, effort, cost);
        EXPECT_EQ(std::get<Indices>(strips_of(list, vertices, plain, effort, cost).indices), expected);
        BuildReport report;
        EXPECT_EQ(std::get<Indices>(strips_of(list, vertices, plain, effort, cost, {}, &report).indices), expected);
      }
  }
}

using sample::Triangles;
using sample::with_backs;

std::size_t index_count(const Triangles& list, StripForm form, Effort effort) {
  Vertex vertices = 0;
  for (const Corners& c : list) vertices = std::max(vertices, *std::max_element(c.begin(), c.end()) + 1);
  const IndexBuffer buffer = strips_of(list, vertices, {.form = form}, effort);
  EXPECT_EQ(form_reader::read(buffer), sample::sorted(list));
  return buffer.size();
}

/// Meshes with edges of more than two triangles: strips continue where the sheets do.
TEST(StripsOf, ContinuesInTheSheetsOfNonManifoldMeshes) {
  const Triangles grid = with_backs(sample::sheet(40, 40, [](Vertex x, Vertex y) { return 41 * x + y; }));
  Triangles shuffled = with_backs(sample::book(7));
  std::mt19937 random(1);
  std::shuffle(shuffled.begin(), shuffled.end(), random);
  for (const Effort effort : {Effort::fast, Effort::full}) {
    EXPECT_LE(index_count(grid, StripForm::restart, effort), 11 * grid.size() / 10);
    EXPECT_LE(index_count(grid, StripForm::stitched, effort), 11 * grid.size() / 10);
    for (const Triangles& list : {sample::book(3), shuffled, with_backs(sample::band(31)), sample::boxes(2)})
      EXPECT_LE(index_count(list, StripForm::restart, effort), 5 * list.size() / 4) << list.size();
  }
}

/// Any list, whatever the effort and the cost: triangles may share two sides, be there twice, or turn their backs; what
/// is degenerate or out of range is left out.
TEST(StripsOf, DrawsEverySoupUnderEveryEffort) {
  std::mt19937 random(4);
  for (unsigned round = 0; round < 80; ++round) {
    const auto vertices = static_cast<Vertex>(4 + random() % 9);
    Triangles list(1 + random() % 30);
    for (Corners& c : list)
      for (Vertex& v : c) v = static_cast<Vertex>(random() % (vertices + round % 2));
    BuildReport report;
    const StripMesh mesh = StripMesh::build(list, vertices, &report);
    ASSERT_EQ(mesh.triangle_count() + report.degenerate_triangles + report.out_of_range_triangles, list.size());
    for (const Effort effort : {Effort::fast, Effort::full, Effort::best})
      for (const Cost cost : {Cost::indices(), Cost::strips()}) {
        const IndexBuffer buffer = strips_of(list, vertices, {}, effort, cost);
        ASSERT_EQ(form_reader::read(buffer), sample::triangles_of(mesh)) << round;
        ASSERT_LE(buffer.size(), 3 * list.size());
        if (effort == Effort::best) continue;
        ASSERT_EQ(std::get<Indices>(strips_of(list, vertices, plain, effort, cost).indices),
                  by_way_of_a_mesh(list, vertices, effort, cost));
      }
  }
}

}  // namespace
}  // namespace restrip
