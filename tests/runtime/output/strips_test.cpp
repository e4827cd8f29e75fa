// An index buffer, decoded the way a graphics card does it, gives back the mesh: each triangle once, oriented as
// before. The decoder, the colouring check and the shortest encoding are computed by other means than in the library.
#include "restrip/output/strips.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "form_reader.hpp"
#include "restrip/mesh/cost.hpp"
#include "restrip/mesh/strip_mesh.hpp"
#include "restrip/mesh/walks.hpp"
#include "restrip/search/keeper.hpp"
#include "restrip/search/stripify.hpp"
#include "sample_meshes.hpp"
#include "search/strip_locator.hpp"

namespace restrip {
namespace {

using Corners = std::array<Vertex, 3>;

// The rotation of a triangle that starts with its smallest corner: the same for equal windings only.
Corners rotated(Corners c) {
  std::rotate(c.begin(), std::min_element(c.begin(), c.end()), c.end());
  return c;
}

// The halfedge of the solid edge between two triangles that follow each other in a strip.
StripMesh::Halfedge solid_between(const StripMesh& mesh, Triangle one, Triangle other) {
  for (unsigned side = 0; side < 3; ++side) {
    const StripMesh::Halfedge h = StripMesh::halfedge(one, side);
    if (mesh.solid(h) && StripMesh::triangle(mesh.opposite(h)) == other) return h;
  }
  return {};
}

// The least number of indices for one strip: all ways to start, then any repeated index, tried in full. State: the last
// two indices, the parity, how many triangles are drawn. With `by_edges` each triangle is entered over the solid edge
// of the mesh. That makes a difference only next to a triangle's own back, which shares all three edges with it.
std::size_t shortest(const StripMesh& mesh, std::span<const Triangle> strip, bool by_edges = false) {
  std::size_t best = 3 * strip.size() + 3;
  for (const bool backwards : {false, true}) {
    std::vector<Triangle> order(strip.begin(), strip.end());
    if (backwards) std::reverse(order.begin(), order.end());
    std::vector<Corners> triangles;
    std::vector<std::array<Vertex, 2>> entry{{none, none}};
    for (std::size_t i = 0; i < order.size(); ++i) {
      triangles.push_back(mesh.corners(order[i]));
      if (i == 0) continue;
      const StripMesh::Halfedge h = solid_between(mesh, order[i - 1], order[i]);
      entry.push_back({mesh.from(h), mesh.to(h)});
    }
    const auto enters = [&](std::size_t triangle, Vertex a, Vertex b) {
      const auto [c, d] = entry[triangle];
      return !by_edges || triangle == 0 || (a == c && b == d) || (a == d && b == c);
    };
    const auto extend = [&](auto&& self, std::vector<std::uint32_t>& text, std::size_t drawn) -> void {
      if (text.size() + (triangles.size() - drawn) >= best) return;
      if (drawn == triangles.size()) {
        best = text.size();
        return;
      }
      for (const Vertex v : triangles[drawn]) {  // the next index: a corner of the triangle to draw
        const std::size_t n = text.size();
        text.push_back(v);
        std::size_t now = drawn;
        bool fits = true;
        if (n >= 2) {
          Corners c{text[n - 2], text[n - 1], v};
          if (n % 2 == 1) std::swap(c[0], c[1]);
          if (c[0] != c[1] && c[1] != c[2] && c[2] != c[0]) {
            fits = rotated(c) == rotated(triangles[drawn]) && enters(drawn, text[n - 2], text[n - 1]);
            ++now;
          }
        }
        if (fits) self(self, text, now);
        text.pop_back();
      }
    };
    std::vector<std::uint32_t> text;
    extend(extend, text, 0);
  }
  return best;
}

TEST(Strips, DecodingGivesBackTheMesh) {
  std::mt19937 random(1);
  for (StripMesh& mesh : sample::meshes()) {
    for (const double share : {0.0, 0.3, 0.7, 1.0}) {
      sample::color_at_random(mesh, share, random);
      const ColoringReport report = check_coloring(mesh);
      ASSERT_TRUE(report.valid);
      const Strips strips = extract_strips(mesh);
      EXPECT_EQ(strips.size(), report.strips);
      EXPECT_EQ(strips.order.size(), mesh.triangle_count());
      const std::vector<std::uint32_t> indices = strip_indices(mesh, strips);
      EXPECT_EQ(indices.size(), strip_index_count(mesh, strips));
      EXPECT_EQ(strip_indices(mesh), indices);
      EXPECT_EQ(form_reader::read_strips(std::span<const std::uint32_t>(indices)), sample::triangles_of(mesh));
    }
  }
}

TEST(Strips, EveryStripIsWrittenAsShortAsCanBe) {
  std::mt19937 random(2);
  for (StripMesh& mesh : sample::meshes()) {
    sample::color_at_random(mesh, 0.85, random);
    const Strips all = extract_strips(mesh);
    for (std::size_t s = 0; s < all.size(); ++s) {
      if (all[s].size() > 12) continue;
      Strips one;
      one.order.assign(all[s].begin(), all[s].end());
      one.start.push_back(one.order.size());
      EXPECT_EQ(strip_index_count(mesh, one), shortest(mesh, all[s]));
    }
  }
}

// Within each strip the swaps known from four colours are the ones for which the written strip repeats an index, but
// for the first turn, which can cost one more. This is about strips that cross the solid edges of the mesh. A strip
// from a triangle to its own back may be written over any of their three edges, of which one is solid; that is a choice
// which can save an index, so what is written is never longer, and now and then shorter.
TEST(Strips, SwapsAreKnownFromFourColours) {
  std::size_t compared = 0;
  std::size_t shorter = 0;
  std::mt19937 random(2);
  for (StripMesh& mesh : sample::meshes()) {
    sample::color_at_random(mesh, 0.8, random);
    const Strips strips = extract_strips(mesh);
    for (std::size_t s = 0; s < strips.size(); ++s) {
      if (strips[s].size() > 12) continue;  // the shortest is found by trying everything
      ++compared;
      std::size_t swaps = 0;
      bool with_backs = false;
      for (std::size_t i = 0; i + 1 < strips[s].size(); ++i) {
        const StripMesh::Halfedge h = solid_between(mesh, strips[s][i], strips[s][i + 1]);
        EXPECT_EQ(is_swap(mesh, h), is_swap(mesh, mesh.opposite(h)));
        swaps += is_swap(mesh, h) ? 1U : 0U;
        with_backs |= mesh.to(StripMesh::next(h)) == mesh.to(StripMesh::next(mesh.opposite(h)));
      }
      const std::size_t by_edges = shortest(mesh, strips[s], true);
      const std::size_t repeated = by_edges - strips[s].size() - 2;
      EXPECT_GE(repeated, swaps);
      EXPECT_LE(repeated, swaps + 1);
      const std::size_t written = shortest(mesh, strips[s]);
      EXPECT_LE(written, by_edges);
      if (!with_backs) {
        EXPECT_EQ(written, by_edges);
      }
      shorter += written < by_edges ? 1U : 0U;
    }
  }
  EXPECT_GT(compared, 50U);
  EXPECT_GT(shorter, 0U);
}

TEST(CheckColoring, FindsWhatIsWrong) {
  StripMesh mesh = sample::octahedron();
  EXPECT_EQ(check_coloring(mesh).isolated, 8U);
  const Vertex apex = mesh.corners(0)[0];
  // The fan of a vertex, closed: one solid cycle.
  StripMesh::Halfedge h = mesh.spoke(apex);
  for (int i = 0; i < 4; ++i, h = turn_ccw(mesh, h)) mesh.set_solid(h, true);
  ColoringReport report = check_coloring(mesh);
  EXPECT_FALSE(report.valid);
  EXPECT_EQ(report.solid_cycles, 1U);
  EXPECT_EQ(report.over_degree, 0U);
  EXPECT_EQ(report.strips, 5U);
  EXPECT_EQ(report.isolated, 4U);
  // A third solid edge at one of them.
  mesh.set_solid(StripMesh::next(h), true);
  report = check_coloring(mesh);
  EXPECT_EQ(report.over_degree, 1U);
  mesh.set_solid(h, false);
  report = check_coloring(mesh);
  EXPECT_TRUE(report.valid);
  EXPECT_EQ(report.strips, 4U);
  EXPECT_EQ(report.isolated, 3U);
}

// ---- colourings that are not valid
// A ring of solid edges lacks an end to locate a strip from, and a triangle of three solid edges is not part of a
// strip.
TEST(InvalidColorings, AreRefusedByReadersOfTheWholeMesh) {
  for (const bool cycle : {true, false}) {
    StripMesh mesh = sample::rectangle(3, 3);
    if (cycle) {
      for_each_spoke(mesh, 5, [&](StripMesh::Halfedge h) { mesh.set_solid(h, true); });
    } else {
      Triangle t = 0;
      const auto inner = [&](unsigned side) {
        return !StripMesh::on_boundary(mesh.opposite(StripMesh::halfedge(t, side)));
      };
      while (!inner(0) || !inner(1) || !inner(2)) ++t;
      for (unsigned side = 0; side < 3; ++side) mesh.set_solid(StripMesh::halfedge(t, side), true);
    }
    ASSERT_FALSE(check_coloring(mesh).valid);
    const auto message = [&](const auto& read) -> std::string {
      try {
        read();
      } catch (const std::invalid_argument& error) {
        return error.what();
      }
      return "nothing thrown";
    };
    const std::string expected = std::string("restrip: the colouring is not valid: ") +
                                 (cycle ? "solid dual edges close a cycle" : "a triangle has three solid dual edges");
    for (const Policy policy : {Policy::local, Policy::quick, Policy::full})
      EXPECT_EQ(message([&] { const Keeper keeper(mesh, policy, Cost::strips()); }), expected);
    EXPECT_EQ(message([&] { const StripLocator locator(mesh); }), expected);
    EXPECT_EQ(message([&] { (void)count_strips(mesh); }), expected);
    mesh.clear_colors();
    Keeper keeper(mesh, Policy::quick, Cost::strips());
    EXPECT_EQ(keeper.strips(), mesh.triangle_count());
    EXPECT_EQ(count_strips(mesh), mesh.triangle_count());
  }
}

}  // namespace
}  // namespace restrip
