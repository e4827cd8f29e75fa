// The buffer draws the mesh after every update, and what is not reported has not changed.
#include "restrip/output/strip_buffer.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>
#include <vector>

#include "random_operation.hpp"
#include "restrip/search/keeper.hpp"
#include "restrip/search/stripify.hpp"
#include "sample_meshes.hpp"

namespace restrip {
namespace {

using Corners = std::array<Vertex, 3>;

Corners smallest_first(Corners c) {
  std::rotate(c.begin(), std::min_element(c.begin(), c.end()), c.end());
  return c;
}

// What a renderer draws, as the specifications of OpenGL and Vulkan have it; degenerate triangles draw nothing.
std::vector<Corners> drawn(std::span<const std::uint32_t> indices) {
  std::vector<Corners> triangles;
  std::size_t begin = 0;
  for (std::size_t i = 0; i < indices.size(); ++i) {
    if (indices[i] == restart_index) begin = i + 1;
    if (i < begin + 2) continue;
    const bool odd = (i - begin) % 2 != 0;
    const Corners c{indices[odd ? i - 1 : i - 2], indices[odd ? i - 2 : i - 1], indices[i]};
    if (c[0] != c[1] && c[1] != c[2] && c[2] != c[0]) triangles.push_back(smallest_first(c));
  }
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

std::vector<Corners> triangles_of(const StripMesh& mesh) {
  std::vector<Corners> triangles;
  for (Triangle t = 0; t < mesh.triangle_bound(); ++t)
    if (mesh.alive(t)) triangles.push_back(smallest_first(mesh.corners(t)));
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

void expect_only_reported_changes(const std::vector<std::uint32_t>& before, std::span<const std::uint32_t> after,
                                  std::span<const StripBuffer::Range> ranges) {
  std::vector<bool> reported(after.size(), false);
  std::size_t end = 0;
  for (const auto& range : ranges) {
    ASSERT_TRUE(end == 0 || range.first > end);
    end = range.first + range.count;
    ASSERT_LE(end, after.size());
    std::fill_n(reported.begin() + static_cast<std::ptrdiff_t>(range.first), range.count, true);
  }
  for (std::size_t i = 0; i < after.size(); ++i)
    if (!reported[i]) {
      ASSERT_TRUE(i < before.size() && before[i] == after[i]) << "index " << i;
    }
}

TEST(StripBuffer, FollowsAnyOperationsUnderAnyPolicy) {
  std::mt19937 random(11);
  for (const Policy policy : {Policy::local, Policy::linked, Policy::quick}) {
    for (const std::uint32_t max_run : {2U, 7U, 64U}) {
      for (StripMesh& mesh : sample::meshes()) {
        StripKeeper keeper(mesh, policy);
        std::vector<Triangle> changed;
        mesh.watch(&changed);
        StripBuffer buffer(mesh, max_run);
        ASSERT_EQ(drawn(buffer.indices()), triangles_of(mesh));
        for (int round = 0; round < 60; ++round) {
          const std::vector<std::uint32_t> before(buffer.indices().begin(), buffer.indices().end());
          for (auto n = random() % 5; n > 0; --n)
            random_operation(keeper, random, mesh.triangle_count() < 60 || (round / 15) % 2 == 0);
          const auto ranges = buffer.update(mesh, changed);
          expect_only_reported_changes(before, buffer.indices(), ranges);
          changed.clear();
          ASSERT_EQ(drawn(buffer.indices()), triangles_of(mesh));
          const auto indices = buffer.indices();  // each run has one restart index that is used
          ASSERT_EQ(buffer.used(),
                    indices.size() + buffer.runs() -
                        static_cast<std::size_t>(std::count(indices.begin(), indices.end(), restart_index)));
          if (HasFatalFailure()) return;
        }
        mesh.watch(nullptr);
      }
    }
  }
}

TEST(StripBuffer, WritesLittleForALittleChangeInALongStrip) {
  StripMesh mesh = sample::torus(60, 60);
  ASSERT_EQ(stripify(mesh, Effort::full), 1U);
  std::vector<Triangle> changed;
  mesh.watch(&changed);
  StripBuffer buffer(mesh, 64);
  const StripMesh::Halfedge h = mesh.spoke(100);
  split(mesh, {h, turn_ccw(mesh, turn_ccw(mesh, h))});
  std::size_t written = 0;
  for (const auto& range : buffer.update(mesh, changed)) written += range.count;
  EXPECT_GT(written, 0U);
  EXPECT_LT(written, 10U * 64U * 2U);  // a patch of eight triangles lies in no more runs, and each doubles at worst
  EXPECT_LT(written * 4, buffer.indices().size());
}

TEST(StripBuffer, NothingChangedNothingWritten) {
  StripMesh mesh = sample::torus(10, 10);
  StripBuffer buffer(mesh);
  EXPECT_TRUE(buffer.update(mesh, {}).empty());
}

TEST(StripBuffer, RunsDoNotCrumble) {
  std::mt19937 random(12);
  StripMesh mesh = sample::torus(40, 40);
  stripify(mesh, Effort::full);
  StripKeeper keeper(mesh, Policy::full);
  std::vector<Triangle> changed;
  mesh.watch(&changed);
  StripBuffer buffer(mesh, 64);
  for (int i = 0; i < 4000; ++i) {
    random_operation(keeper, random, (i / 500) % 2 == 0);
    buffer.update(mesh, changed);
    changed.clear();
  }
  EXPECT_LT(buffer.runs(), keeper.strips() + mesh.triangle_count() / 12);
  EXPECT_LT(buffer.indices().size(), 2 * buffer.used() + 2048);
}

// One strip of 130 triangles in runs of 43, 43 and 44, cut anywhere: less than a quarter of max_run that the cut leaves
// of a run joins the run beside it.
TEST(StripBuffer, ShortRunsAreTakenIn) {
  StripMesh ring = sample::tube(65, 1);
  stripify(ring, Effort::full);
  const Strips strips = extract_strips(ring);
  ASSERT_EQ(strips.size(), 1U);
  const auto strip = strips[0];
  ASSERT_EQ(strip.size(), 130U);
  for (std::size_t i = 1; i < strip.size(); ++i) {
    StripMesh mesh = ring;
    std::vector<Triangle> changed;
    mesh.watch(&changed);
    StripBuffer buffer(mesh, 64);
    ASSERT_EQ(buffer.runs(), 3U);
    for (unsigned side = 0; side < 3; ++side)
      if (const auto h = StripMesh::halfedge(strip[i], side);
          mesh.solid(h) && StripMesh::triangle(mesh.opposite(h)) == strip[i - 1])
        mesh.set_solid(h, false);
    buffer.update(mesh, changed);
    const auto near = [i](std::size_t end) { return i < end + 16 && i + 16 > end; };
    EXPECT_EQ(buffer.runs(), near(43) || near(86) ? 3U : 4U) << "cut before triangle " << i;
    EXPECT_EQ(drawn(buffer.indices()), triangles_of(mesh));
  }
}

// A cycle of solid edges is not drawn right, but an update ends; and when the cycle is open again, all is drawn.
TEST(StripBuffer, AnUpdateEndsWhereColorsAreNotValid) {
  StripMesh mesh = sample::double_cone(8);
  std::vector<Triangle> changed;
  mesh.watch(&changed);
  StripBuffer buffer(mesh);
  for (Vertex v = 2; v < 10; ++v) mesh.set_solid(mesh.spoke(0, v), true);
  buffer.update(mesh, changed);
  EXPECT_LT(buffer.indices().size(), 200U);
  changed.clear();
  mesh.set_solid(mesh.spoke(0, 2), false);
  buffer.update(mesh, changed);
  EXPECT_EQ(drawn(buffer.indices()), triangles_of(mesh));
}

// Runs have at least two triangles, whatever is asked for.
TEST(StripBuffer, RunsAreNeverShorterThanTwo) {
  StripMesh mesh = sample::torus(12, 9);
  stripify(mesh);
  const StripBuffer two(mesh, 2);
  EXPECT_GE(two.runs(), mesh.triangle_count() / 2);
  EXPECT_EQ(drawn(two.indices()), triangles_of(mesh));
  for (const std::uint32_t max_run : {0U, 1U}) {
    const StripBuffer buffer(mesh, max_run);
    EXPECT_TRUE(
        std::equal(buffer.indices().begin(), buffer.indices().end(), two.indices().begin(), two.indices().end()));
  }
}

// A watch goes where its mesh is moved, and nowhere else.
TEST(StripMesh, AWatchMovesWithItsMesh) {
  const auto changes = [](StripMesh& mesh, const std::vector<Triangle>& list) {
    const std::size_t before = list.size();
    const StripMesh::Halfedge h = mesh.spoke(0);
    mesh.set_solid(h, !mesh.solid(h));
    return list.size() - before;
  };
  std::vector<Triangle> list;
  std::vector<Triangle> other_list;
  StripMesh mesh = sample::torus(4, 3);
  mesh.watch(&list);
  EXPECT_EQ(changes(mesh, list), 2U);

  StripMesh moved = std::move(mesh);
  EXPECT_EQ(changes(moved, list), 2U);
  mesh = sample::octahedron();  // no longer watched, and a new mesh is not either
  EXPECT_EQ(changes(mesh, list), 0U);

  moved = sample::octahedron();  // a mesh without a watch is assigned: moved keeps its own
  EXPECT_EQ(changes(moved, list), 2U);
  const StripMesh original = sample::octahedron();
  moved = original;
  EXPECT_EQ(changes(moved, list), 2U);

  mesh.watch(&other_list);
  std::swap(mesh, moved);
  EXPECT_EQ(changes(mesh, list), 2U);
  EXPECT_EQ(changes(moved, other_list), 2U);

  moved = std::move(mesh);  // two watches, one mesh: the one that comes along stays
  EXPECT_EQ(changes(moved, list), 2U);
  EXPECT_EQ(changes(moved, other_list), 0U);

  StripMesh copy = moved;
  EXPECT_EQ(changes(copy, list), 0U);
}

TEST(StripMesh, ACopyIsNotWatched) {
  StripMesh mesh = sample::torus(5, 5);
  std::vector<Triangle> changed;
  mesh.watch(&changed);
  StripMesh copy = mesh;
  copy.set_solid(copy.spoke(0), true);
  EXPECT_TRUE(changed.empty());
  mesh.set_solid(mesh.spoke(0), true);
  EXPECT_EQ(changed.size(), 2U);
}

}  // namespace
}  // namespace restrip
