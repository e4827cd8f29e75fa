// What live buffers promise beyond live_random_test.cpp, which draws them after random operations from the ranges that
// updates return: widths, room and windows. A buffer of strips is never much longer than the strips, and an update
// writes little; of a list only the changed corners are written.
#include "restrip/output/live_buffer.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <random>
#include <stdexcept>
#include <vector>

#include "form_reader.hpp"
#include "measure/vertex_cache.hpp"
#include "output/strip_buffer.hpp"
#include "output/triangle_list_buffer.hpp"
#include "random_operations.hpp"
#include "restrip/operations/operations.hpp"
#include "restrip/search/keeper.hpp"
#include "restrip/search/stripify.hpp"
#include "sample_meshes.hpp"

namespace restrip {
namespace {

constexpr std::array forms{StripForm::restart, StripForm::stitched, StripForm::lengths, StripForm::list};
constexpr std::size_t most = std::numeric_limits<std::size_t>::max();
constexpr std::array widths{IndexWidth::bits16, IndexWidth::bits32, IndexWidth::automatic};

TEST(LiveBuffer, WidensWhenAVertexNeedsIt) {
  for (const StripForm form : forms) {
    StripMesh mesh = sample::torus(8, 8);
    stripify(mesh);
    std::vector<Triangle> changed;
    mesh.watch(&changed);
    LiveBuffer buffer({.form = form});
    LiveBuffer narrow({.form = form, .width = IndexWidth::bits16});
    buffer.update(mesh, changed);
    narrow.update(mesh, changed);
    Keeper keeper(mesh, Policy::rules);
    for (const Vertex name : {65'534U, 65'535U}) {
      changed.clear();
      keeper.split({mesh.spoke(5), turn_ccw(mesh, turn_ccw(mesh, mesh.spoke(5)))}, name);
      EXPECT_EQ(buffer.update(mesh, changed).outgrown, name == 65'535);
      EXPECT_EQ(buffer.index_bytes(), name == 65'535 ? 4U : 2U);
      if (name == 65'534) narrow.update(mesh, changed);
    }
    std::vector<IndexRange> draws;
    buffer.draws(draws);
    EXPECT_EQ(form_reader::drawn(buffer.bytes(), buffer.index_bytes(), form, draws), sample::triangles_of(mesh));
    // An update that throws leaves the buffer as it was.
    const std::vector<std::byte> before(narrow.bytes().begin(), narrow.bytes().end());
    EXPECT_THROW(narrow.update(mesh, changed), std::length_error);
    EXPECT_TRUE(std::equal(before.begin(), before.end(), narrow.bytes().begin(), narrow.bytes().end()));
  }
}

/// Whichever corner of a strip of a few triangles has the number that 16 bits cannot name.
TEST(LiveBuffer, RefusesAVertexForSixteenBitsAnywhereInAStrip) {
  for (const StripForm form : forms)
    for (Vertex triangles = 1; triangles <= 5; ++triangles)
      for (Vertex place = 0; place < triangles + 2; ++place)
        for (const Vertex name : {65'534U, 65'535U}) {
          std::vector<Vertex> indices;
          for (Vertex i = 0; i < triangles; ++i)
            for (const Vertex corner : {i, i + 1 + i % 2, i + 2 - i % 2})
              indices.push_back(corner == place ? name : corner);
          StripMesh mesh = StripMesh::build(indices, 65'536);
          ASSERT_EQ(stripify(mesh), 1U);
          LiveBuffer narrow({.form = form, .width = IndexWidth::bits16});
          if (name == 65'535)
            EXPECT_THROW(narrow.update(mesh, {}), std::length_error) << triangles << ' ' << place;
          else
            EXPECT_NO_THROW(narrow.update(mesh, {})) << triangles << ' ' << place;
        }
}

/// Room that was reserved is asked for once; then no update reports an outgrown buffer.
TEST(LiveBuffer, ReservesRoomOnTheDevice) {
  std::mt19937 random(23);
  for (const StripForm form : forms)
    for (const IndexWidth width : widths) {
      StripMesh mesh = sample::octahedron();
      stripify(mesh);
      Keeper keeper(mesh, Policy::quick, Cost::indices());
      std::vector<Triangle> changed;
      mesh.watch(&changed);
      LiveBuffer buffer({.form = form, .width = width});
      buffer.update(mesh, changed);
      for (const std::size_t triangles : {most, most / 2 + 1, most / 3 + 1})
        EXPECT_THROW(buffer.reserve(triangles), std::length_error);
      buffer.reserve(1000);
      for (int round = 0; round < 150; ++round) {
        changed.clear();
        random_operation(keeper, random, true);
        ASSERT_EQ(buffer.update(mesh, changed).outgrown, round == 0);
      }
      EXPECT_GT(mesh.triangle_count(), 100U);
      mesh.watch(nullptr);
    }
}

TEST(LiveBuffer, HasNoBatches) {
  EXPECT_THROW(LiveBuffer({.most_vertices = 64}), std::invalid_argument);
  EXPECT_THROW(LiveBuffer({.most_indices = 64}), std::invalid_argument);
  EXPECT_THROW(LiveBuffer({.most_vertices = 3, .most_indices = most - 2}), std::invalid_argument);
}

/// A stitched buffer drawn in windows of any even number of indices: each triangle once, with its winding.
TEST(LiveBuffer, DrawsAStitchedBufferInWindows) {
  std::mt19937 random(24);
  for (const IndexWidth width : widths)
    for (StripMesh& mesh : sample::meshes()) {
      stripify(mesh);
      Keeper keeper(mesh, Policy::quick, Cost::indices());
      std::vector<Triangle> changed;
      mesh.watch(&changed);
      LiveBuffer buffer({.form = StripForm::stitched, .width = width});
      for (int round = 0; round < 30; ++round) {
        buffer.update(mesh, changed);
        changed.clear();
        for (const std::size_t n : {std::size_t{4}, std::size_t{6}, 2 * (4 + random() % 60)}) {
          form_reader::Reader reader(buffer.bytes(), buffer.index_bytes());
          for (std::size_t first = 0; first + 2 < buffer.size(); first += n - 2)
            reader.strip(first, std::min(n, buffer.size() - first), false);
          ASSERT_EQ(std::move(reader).triangles(), sample::triangles_of(mesh));
        }
        for (auto n = random() % 8; n > 0; --n) random_operation(keeper, random, mesh.triangle_count() < 60);
      }
      mesh.watch(nullptr);
    }
}

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

// A flip changes two corners, a split one of each triangle that goes to the new vertex and two triangles.
TEST(TriangleListBuffer, WritesTheCornersThatChanged) {
  StripMesh mesh = sample::torus(30, 30);
  std::vector<Triangle> changed;
  mesh.watch(&changed);
  TriangleListBuffer buffer(mesh);
  const auto written = [&] {
    std::size_t sum = 0;
    for (const auto& range : buffer.update(mesh, changed)) sum += range.count;
    changed.clear();
    return sum;
  };
  const StripMesh::Halfedge h = mesh.spoke(100);
  split(mesh, {h, turn_cw(mesh, turn_cw(mesh, h))});
  EXPECT_EQ(written(), 2U + 6U);
  EXPECT_EQ(written(), 0U);
  const StripMesh beyond = StripMesh::build(std::vector<sample::Corners>{{0, 1, 65'535}}, 65'536);
  EXPECT_THROW(TriangleListBuffer(beyond, IndexWidth::bits16), std::length_error);
}

TEST(TriangleListBuffer, PaddingIsWrittenOnlyWhenItChanges) {
  StripMesh mesh = StripMesh::build(std::vector<sample::Corners>{{0, 1, 2}, {2, 1, 3}, {4, 5, 6}}, 7);
  std::vector<Triangle> changed;
  mesh.watch(&changed);
  TriangleListBuffer buffer(mesh, IndexWidth::bits16);
  ASSERT_EQ(buffer.indices16().size(), 10U);
  EXPECT_TRUE(buffer.update(mesh, changed, {.merge_gap = 0, .align = 2}).empty());
  Keeper keeper(mesh, Policy::bare, Cost::indices());
  keeper.flip(mesh.spoke(1, 2));
  const auto ranges = buffer.update(mesh, changed, {.merge_gap = 0, .align = 2});
  ASSERT_FALSE(ranges.empty());
  EXPECT_LE(ranges.back().first + ranges.back().count, 6U);
}

}  // namespace
}  // namespace restrip
