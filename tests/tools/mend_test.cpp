// Claims: welding joins vertices at one position and changes nothing else; orienting turns the fewest triangles so that
// neighbours agree, and refuses non-orientable surfaces; strips in the file draw the mended triangles and become the
// colouring of the mesh.
#include "meshes/mend.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "lod/coloring_check.hpp"
#include "meshes/made_mesh.hpp"
#include "meshes/mesh_report.hpp"
#include "meshes/strip_file.hpp"
#include "restrip/output/strips.hpp"
#include "shapes.hpp"
#include "support/refusal_of.hpp"

namespace restrip::tools {
namespace {

/// Every triangle with three separate vertices.
Soup apart(const Soup& soup) {
  Soup made;
  for (const Corners& t : soup.triangles) {
    const auto first = static_cast<std::uint32_t>(made.points.size());
    for (const std::uint32_t corner : t) made.points.push_back(soup.points[corner]);
    made.triangles.push_back({first, first + 1, first + 2});
  }
  return made;
}

/// The positions of the corners, which welding must not change.
std::vector<Point> places(const Soup& soup) {
  std::vector<Point> found;
  for (const Corners& t : soup.triangles)
    for (const std::uint32_t corner : t) found.push_back(soup.points[corner]);
  return found;
}

TEST(Mend, WeldingPutsTrianglesTogetherAgain) {
  const Soup whole = make_mesh(2000);
  Soup soup = apart(whole);
  EXPECT_EQ(coincident_vertices(soup), soup.points.size() - whole.points.size());
  const std::vector<Point> before = places(soup);
  Mended mended;
  weld(soup, mended);
  EXPECT_EQ(soup.points.size(), whole.points.size());
  EXPECT_EQ(mended.welded_vertices, before.size() - whole.points.size());
  EXPECT_EQ(mended.vanished_triangles, 0U);
  EXPECT_EQ(places(soup), before);
  EXPECT_EQ(report_on(soup).genus, report_on(whole).genus);
  EXPECT_EQ(coincident_vertices(soup), 0U);
}

TEST(Mend, TheTwoZerosAreOnePlaceAndFlatTrianglesVanish) {
  Soup soup{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-0.0F, 0, 0}}, {{0, 1, 2}, {0, 3, 1}, {3, 2, 1}, {0, 0, 1}}};
  Mended mended;
  weld(soup, mended);
  EXPECT_EQ(soup.triangles, (std::vector<Corners>{{0, 1, 2}, {0, 2, 1}, {0, 0, 1}}));
  EXPECT_EQ(mended.welded_vertices, 1U);
  EXPECT_EQ(mended.vanished_triangles, 1U) << "one was degenerate before, and stays as it was";
}

TEST(Mend, OrientingTurnsTheFewest) {
  const Soup whole = make_mesh(2000);
  Soup soup = whole;
  for (const std::size_t t : {3U, 4U, 700U, 1500U}) std::swap(soup.triangles[t][1], soup.triangles[t][2]);
  Mended mended;
  orient(soup, "f", mended);
  EXPECT_EQ(mended.turned_triangles, 4U);
  EXPECT_EQ(sorted_triangles(soup.triangles), sorted_triangles(whole.triangles));
  // Each component separately; an edge of three triangles decides nothing.
  Soup fins{{{}, {}, {}, {}, {}}, {{0, 1, 2}, {0, 1, 3}, {1, 0, 4}}};
  orient(fins, "f", mended);
  EXPECT_EQ(mended.turned_triangles, 4U);
}

TEST(Mend, WhatHasOneSideIsRefused) {
  // Five triangles around the band, vertices 0 to 4.
  Soup band{{{}, {}, {}, {}, {}}, {{0, 1, 2}, {1, 3, 2}, {2, 3, 4}, {3, 0, 4}, {4, 0, 1}}};
  const Soup before = band;
  Mended mended;
  const std::string said = refusal_of([&] { orient(band, "some.file", mended); });
  EXPECT_TRUE(said.starts_with("some.file: --orient")) << said << ": a Moebius strip has no orientation";
  EXPECT_EQ(band.triangles, before.triangles);
}

TEST(Mend, StripsOfTheFileStayWhatIsDrawn) {
  constexpr std::uint32_t n = 6;
  const auto row = [](std::uint32_t i) {
    std::vector<std::uint32_t> strip;
    for (std::uint32_t j = 0; j <= n; ++j) strip.insert(strip.end(), {i * (n + 1) + j, (i + 1) * (n + 1) + j});
    return strip;
  };
  Soup soup;
  soup.points = sheet(n).points;
  std::vector<Corners> whole;
  const auto add = [&](const std::vector<std::uint32_t>& strip) {
    if (!soup.strips.empty()) soup.strips.push_back(strip_end);
    soup.strips.insert(soup.strips.end(), strip.begin(), strip.end());
  };
  for (std::uint32_t i = 0; i < n; ++i) {
    std::vector<std::uint32_t> strip = row(i);
    const std::vector<Corners> drawn = decode_strips(strip);
    whole.insert(whole.end(), drawn.begin(), drawn.end());
    if (i == 1) strip.insert(strip.begin(), strip.front());  // one more index turns the whole strip
    if (i == 2) {                                            // stitched to the next row, which is turned over
      const std::vector<std::uint32_t> next = row(3);
      strip.insert(strip.end(), {strip.back(), strip.back(), next.front()});
      strip.insert(strip.end(), next.begin(), next.end());
    }
    if (i != 3) add(strip);
  }
  soup.triangles = decode_strips(soup.strips);
  ASSERT_NE(sorted_triangles(soup.triangles), sorted_triangles(whole));
  Mended mended;
  orient(soup, "f", mended);
  EXPECT_EQ(mended.turned_triangles, 4U * n);
  EXPECT_EQ(sorted_triangles(soup.triangles), sorted_triangles(whole));
  std::vector<Corners> drawn = decode_strips(soup.strips);
  std::vector<Corners> wanted = soup.triangles;
  for (auto* list : {&drawn, &wanted})
    for (Corners& t : *list) t = rotated(t);
  EXPECT_EQ(drawn, wanted) << "in their order";
  EXPECT_EQ(std::count(soup.strips.begin(), soup.strips.end(), strip_end), 3 + 4 * n) << "four rows, and two in pieces";
}

TEST(FileStrips, BecomeTheColouring) {
  Soup soup;
  soup.points = sheet(5).points;
  soup.triangles = {{0, 0, 1}};  // listed, and in no strip
  const std::vector<std::uint32_t> strip{0, 6, 7, 13, strip_end, 1, 0, 7, strip_end, 7, 13, 8, 14, 9};
  soup.strips = strip;
  for (const Corners& t : decode_strips(strip)) soup.triangles.push_back(t);
  std::vector<std::uint32_t> origin;
  StripMesh mesh = StripMesh::build(soup.triangles, soup.points.size(), nullptr, &origin);
  const FileStrips done = color_as_in_file(mesh, soup, origin);
  EXPECT_TRUE(find_faults(mesh).empty());
  EXPECT_EQ(count_strips(mesh), mesh.triangle_count() - done.solid);
  const std::size_t within = soup.triangles.size() - 1 - 3;  // steps from triangle to triangle within three strips
  EXPECT_EQ(done.solid, within);
  EXPECT_EQ(done.cut, 0U);
}

}  // namespace
}  // namespace restrip::tools
