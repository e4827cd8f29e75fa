// The buffer is never much longer than the strips, and an update writes little; that it draws the mesh after every
// update is in live_random_test.cpp.
#include "output/strip_buffer.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <stdexcept>
#include <vector>

#include "form_reader.hpp"
#include "measure/vertex_cache.hpp"
#include "random_operation.hpp"
#include "restrip/search/keeper.hpp"
#include "restrip/search/stripify.hpp"
#include "sample_meshes.hpp"

namespace restrip {
namespace {

// The promise of the header.
std::size_t most_indices(const StripMesh& mesh) {
  return strip_indices(mesh, extract_strips(mesh)).size() * 110 / 100 + 128;
}

// A mesh grows to twice its size, shrinks to a tenth and grows again; the length is looked at after every operation.
TEST(StripBuffer, IsNeverMuchLongerThanTheStrips) {
  for (const Policy policy : {Policy::local, Policy::quick}) {
    std::mt19937 random(12);
    StripMesh mesh = sample::torus(24, 24);
    stripify(mesh, Effort::fast, Cost::strips());
    Keeper keeper(mesh, policy, Cost::strips());
    std::vector<Triangle> changed;
    mesh.watch(&changed);
    StripBuffer buffer(mesh);
    bool grow = true;
    std::size_t turns = 0;
    std::size_t least_runs = buffer.runs();
    for (int i = 0; turns < 4; ++i) {
      random_operation(keeper, random, grow);
      buffer.update(mesh, changed);
      changed.clear();
      if (i % 50 == 0) {
        ASSERT_EQ(form_reader::read_strips(buffer.indices()), sample::triangles_of(mesh));
      }
      ASSERT_LE(buffer.indices().size(), most_indices(mesh)) << mesh.triangle_count() << " triangles";
      least_runs = std::min(least_runs, buffer.runs());
      if (grow ? mesh.triangle_count() > 2400 : mesh.triangle_count() < 200) {
        grow = !grow;
        ++turns;
        // Two runs that meet within a strip have more than 28 triangles together.
        EXPECT_LE(buffer.runs(), keeper.strips() + 2 * mesh.triangle_count() / 29);
      }
    }
    EXPECT_GT(least_runs, 0U);
  }
}

// A strip is cut at a share of its triangles, whose product with the number of cuts needs more than 32 bits.
TEST(StripBuffer, CutsAStripOfHundredsOfThousandsOfTriangles) {
  StripMesh mesh = sample::rectangle(200'000, 1);
  for (const StripMesh::Halfedge h : sample::dual_edges(mesh)) mesh.set_solid(h, true);
  const StripBuffer buffer(mesh);
  EXPECT_GT(buffer.runs(), mesh.triangle_count() / 37);
  EXPECT_LE(buffer.runs(), mesh.triangle_count() / 20);
  EXPECT_EQ(form_reader::read_strips(buffer.indices()), sample::triangles_of(mesh));
}

// The most indices between two restart indices.
std::size_t longest_run(std::span<const std::uint32_t> indices) {
  std::size_t longest = 0;
  std::size_t length = 0;
  for (const std::uint32_t index : indices) {
    length = index == restart_index ? 0 : length + 1;
    longest = std::max(longest, length);
  }
  return longest;
}

TEST(StripBuffer, WritesLittleForALittleChangeInALongStrip) {
  StripMesh mesh = sample::torus(60, 60);
  ASSERT_EQ(stripify(mesh, Effort::full, Cost::strips()), 1U);
  std::vector<Triangle> changed;
  mesh.watch(&changed);
  StripBuffer buffer(mesh);
  EXPECT_LE(longest_run(buffer.indices()), 2U * 36U + 1U);  // 36 triangles that all turn the same way
  const StripMesh::Halfedge h = mesh.spoke(100);
  split(mesh, {h, turn_ccw(mesh, turn_ccw(mesh, h))});
  std::size_t written = 0;
  for (const auto& range : buffer.update(mesh, changed)) written += range.count;
  EXPECT_GT(written, 0U);
  // A patch of eight triangles lies in no more runs; each is written twice at worst.
  EXPECT_LT(written, 8U * 2U * (2U * 36U + 2U));
  EXPECT_EQ(form_reader::read_strips(buffer.indices()), sample::triangles_of(mesh));
}

// A run that is read is written as it was, unless it begins and ends next to the same vertex: it may be reversed.
TEST(StripBuffer, WritesOnlyWhatDiffers) {
  StripMesh mesh = sample::torus(60, 60);
  stripify(mesh, Effort::full, Cost::strips());
  StripBuffer buffer(mesh);
  std::size_t updates = 0;
  std::size_t writing = 0;
  for (Triangle t = 0; t < mesh.triangle_bound(); t += 7, ++updates) {
    const std::vector<Triangle> named{t};
    writing += buffer.update(mesh, named).empty() ? 0U : 1U;
  }
  EXPECT_LT(100 * writing, updates);
  EXPECT_EQ(form_reader::read_strips(buffer.indices()), sample::triangles_of(mesh));
  // A run that is cut into two: one of them stays where it is.
  std::vector<Triangle> changed;
  mesh.watch(&changed);
  const std::size_t runs = buffer.runs();
  const StripMesh::Halfedge h = StripMesh::halfedge(2000, static_cast<unsigned>(mesh.solid({2000U << 2}) ? 0 : 1));
  mesh.set_solid(h, false);
  std::size_t written = 0;
  for (const auto& range : buffer.update(mesh, changed)) written += range.count;
  EXPECT_LE(buffer.runs(), runs + 1);
  EXPECT_LT(written, 2U * 36U + 2U + 8U);  // one of the two parts of a run, and its old place
  EXPECT_EQ(form_reader::read_strips(buffer.indices()), sample::triangles_of(mesh));
}

// Runs that lie within one strip, and have become short, are one after an update that names a triangle of either.
TEST(StripBuffer, ShortRunsOfAStripBecomeOne) {
  StripMesh mesh = sample::torus(30, 30);
  ASSERT_EQ(stripify(mesh, Effort::full, Cost::strips()), 1U);
  std::vector<Triangle> changed;
  mesh.watch(&changed);
  StripBuffer buffer(mesh);
  for (Triangle t = 0; t < mesh.triangle_bound(); t += 3) {
    for (unsigned side = 0; side < 3; ++side) mesh.set_solid(StripMesh::halfedge(t, side), false);
    buffer.update(mesh, changed);
    changed.clear();
  }
  const std::size_t strips = check_coloring(mesh).strips;
  EXPECT_GT(buffer.runs(), strips);
  for (Triangle t = 0; t < mesh.triangle_bound(); ++t) buffer.update(mesh, std::vector<Triangle>{t});
  EXPECT_EQ(buffer.runs(), strips);
  EXPECT_EQ(form_reader::read_strips(buffer.indices()), sample::triangles_of(mesh));
}

// Runs are ordered for the cache at first, and new runs are put near their neighbours: by the misses of a mesh with the
// same operations whose runs are not ordered.
TEST(StripBuffer, KeepsAnOrderThatAVertexCacheLikes) {
  constexpr std::size_t changes = 1500;
  struct Counts {
    double at_first;
    double changed;
  };
  const auto counts = [](const LayoutOptions& layout) {
    StripMesh mesh = sample::torus(70, 60, 2);
    stripify(mesh, Effort::fast, Cost::indices());
    Keeper keeper(mesh, Policy::quick, Cost::indices());
    std::vector<Triangle> changed;
    mesh.watch(&changed);
    StripBuffer buffer(StripForm::restart, layout);
    buffer.rebuild(mesh);
    const auto misses = [&] { return acmr(buffer.indices(), 32, mesh.triangle_count()); };
    Counts all{misses(), 0};
    std::mt19937 random(21);
    for (std::size_t i = 0; i < changes; ++i) {
      random_operation(keeper, random, mesh.triangle_count() < 8400);
      buffer.update(mesh, changed);
      changed.clear();
    }
    all.changed = misses();
    EXPECT_EQ(form_reader::read_strips(buffer.indices()), sample::triangles_of(mesh));
    mesh.watch(nullptr);
    return all;
  };
  const Counts ordered = counts({.cache = 32});
  const Counts other = counts({.cache = 0});
  EXPECT_LT(ordered.at_first, 0.72);
  EXPECT_GT(other.at_first, 0.85);
  EXPECT_LT(ordered.changed, 0.9 * other.changed);
}

TEST(StripBuffer, LayoutsAreChecked) {
  for (const LayoutOptions& layout : {LayoutOptions{.cache = 65}, {.waste = 1'000'001}, {.work = 101}})
    for (const StripForm form : {StripForm::restart, StripForm::list})
      EXPECT_THROW(LiveBuffer({.form = form}, layout), std::invalid_argument);
}

TEST(StripBuffer, SixteenBitIndices) {
  std::vector<Triangle> changed;
  // Vertex 65,534 is the last that fits.
  const std::vector<sample::Corners> last{{0, 1, 65'534}};
  const std::vector<sample::Corners> beyond{{0, 1, 65'535}};
  const StripMesh fits = StripMesh::build(last, 65'536);
  StripMesh does_not = StripMesh::build(beyond, 65'536);
  EXPECT_EQ(form_reader::read_strips(StripBuffer(fits, IndexWidth::bits16).indices16()), sample::triangles_of(fits));
  EXPECT_THROW(StripBuffer(does_not, IndexWidth::bits16), std::length_error);
  // An update that throws leaves the buffer as it was; the next one writes everything again.
  StripMesh grown = StripMesh::build(std::vector<sample::Corners>{{0, 1, 2}, {0, 2, 3}}, 65'536);
  grown.watch(&changed);
  StripBuffer kept(grown, IndexWidth::bits16);
  const std::vector<std::uint16_t> before(kept.indices16().begin(), kept.indices16().end());
  using Where = VertexSplit;
  const auto chord = grown.insert_vertex(Where{grown.spoke(0, 2), {}, Where::Spokes::left_only}, 65'535);
  EXPECT_THROW(kept.update(grown, changed), std::length_error);
  EXPECT_TRUE(std::equal(before.begin(), before.end(), kept.indices16().begin(), kept.indices16().end()));
  changed.clear();
  grown.remove_vertex(chord);
  changed.clear();
  EXPECT_EQ(kept.update(grown, changed).size(), 1U);
  EXPECT_EQ(form_reader::read_strips(kept.indices16()), sample::triangles_of(grown));
}

// A cycle of solid edges is not drawn right, but an update ends; and when the cycle is open again, all is drawn.
TEST(StripBuffer, AnUpdateEndsWhereColorsAreNotValid) {
  StripMesh mesh = sample::double_cone(8);
  std::vector<Triangle> changed;
  mesh.watch(&changed);
  StripBuffer buffer(mesh);
  for (Vertex v = 2; v < 10; ++v) mesh.set_solid(mesh.spoke(0, v), true);
  buffer.update(mesh, changed);
  EXPECT_LT(buffer.indices().size(), 300U);
  changed.clear();
  mesh.set_solid(mesh.spoke(0, 2), false);
  buffer.update(mesh, changed);
  EXPECT_EQ(form_reader::read_strips(buffer.indices()), sample::triangles_of(mesh));
}

}  // namespace
}  // namespace restrip
