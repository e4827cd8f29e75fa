// Simplification through the C interface is that of the programs: the same triangles and records, which lead back to
// the mesh when the interface plays them. What stops short says why, and arguments that are wrong are named.
#include "lod/simplify.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>

#include "handle.hpp"
#include "meshes/made_mesh.hpp"
#include "support/failing_new.hpp"
#include "tools/shapes.hpp"

namespace restrip::c_test {
namespace {

using tools::Soup;
using Corners = std::array<std::uint32_t, 3>;

struct FreeLevels {
  void operator()(restrip_levels* levels) const { restrip_levels_free(levels); }
};
using Levels = std::unique_ptr<restrip_levels, FreeLevels>;

/// A mesh as the interface takes it.
struct Input {
  explicit Input(const Soup& soup) {
    for (const auto& t : soup.triangles) indices.insert(indices.end(), t.begin(), t.end());
    for (const auto& p : soup.points) points.insert(points.end(), {p.x, p.y, p.z});
    narrow.assign(indices.begin(), indices.end());
  }
  [[nodiscard]] std::size_t vertex_count() const { return points.size() / 3; }
  restrip_status simplify(std::size_t wanted, std::int32_t boundary, Levels& levels, std::string* text = nullptr,
                          restrip_build_report* report = nullptr) const {
    restrip_levels* made = nullptr;
    char said[100] = "?";
    const restrip_status status = restrip_simplify_u32(indices.data(), indices.size(), points.data(), vertex_count(),
                                                       wanted, boundary, report, said, sizeof said, &made);
    levels.reset(made);
    EXPECT_EQ(made != nullptr, status == RESTRIP_OK);
    if (text != nullptr) *text = said;
    return status;
  }
  std::vector<std::uint32_t> indices;
  std::vector<std::uint16_t> narrow;
  std::vector<double> points;
};

restrip_levels_view view_of(const Levels& levels) {
  restrip_levels_view view{};
  EXPECT_EQ(restrip_levels_read(levels.get(), &view), RESTRIP_OK);
  return view;
}
std::vector<Corners> triangles_of(const restrip_levels_view& view) {
  std::vector<Corners> triangles;
  for (std::size_t i = 0; i < view.base_count; i += 3)
    triangles.push_back({view.base[i], view.base[i + 1], view.base[i + 2]});
  return triangles;
}
/// Each from its smallest corner on: equal for equal sets with equal windings.
std::vector<Corners> sorted(std::vector<Corners> triangles) {
  for (Corners& t : triangles) std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

void expect_equal(const restrip_levels_view& view, const tools::Simplification& expected) {
  std::vector<Corners> base(expected.mesh.base.begin(), expected.mesh.base.end());
  EXPECT_EQ(triangles_of(view), base);
  ASSERT_EQ(view.record_count, expected.mesh.splits.size());
  for (std::size_t i = 0; i < view.record_count; ++i) {
    const restrip_record& record = view.records[i];
    ASSERT_EQ((SplitRecord{record.v_s, record.v_t, record.v_l, record.v_r}), expected.mesh.splits[i]) << i;
  }
  ASSERT_EQ(view.obstacle_count, expected.left_out.obstacles.size());
  for (std::size_t i = 0; i < view.obstacle_count; ++i) {
    EXPECT_STREQ(view.obstacles[i].why, expected.left_out.obstacles[i].why);
    EXPECT_EQ(view.obstacles[i].edges, expected.left_out.obstacles[i].edges);
  }
}

TEST(CSimplify, LevelsAreThoseOfTheProgramsAndLeadBack) {
  for (const Soup& soup : {tools::make_mesh(2'000), tools::sheet(12), tools::tetrahedron()})
    for (const std::int32_t boundary : {RESTRIP_BOUNDARY_LOCK, RESTRIP_BOUNDARY_MOVE})
      for (const std::size_t wanted : {soup.triangles.size(), soup.triangles.size() / 4, std::size_t{1}}) {
        SCOPED_TRACE(std::to_string(soup.triangles.size()) + " to " + std::to_string(wanted));
        const Input input(soup);
        const auto expected = tools::simplify(
            soup, {.boundary = boundary == RESTRIP_BOUNDARY_LOCK ? BoundaryPolicy::lock : BoundaryPolicy::move,
                   .triangles = wanted});
        Levels levels;
        std::string text;
        ASSERT_EQ(input.simplify(wanted, boundary, levels, &text), RESTRIP_OK);
        EXPECT_EQ(text, "");
        const restrip_levels_view view = view_of(levels);
        expect_equal(view, expected);
        EXPECT_EQ(view.obstacle_count == 0, view.base_count <= 3 * wanted);

        restrip_levels* narrow = nullptr;
        ASSERT_EQ(restrip_simplify_u16(input.narrow.data(), input.narrow.size(), input.points.data(),
                                       input.vertex_count(), wanted, boundary, nullptr, nullptr, 0, &narrow),
                  RESTRIP_OK);
        expect_equal(view_of(Levels(narrow)), expected);

        restrip_mesh* made = nullptr;
        ASSERT_EQ(restrip_mesh_build_u32(view.base, view.base_count, input.vertex_count(), nullptr, nullptr, &made),
                  RESTRIP_OK);
        const Handle mesh(made);
        std::size_t done = 0;
        ASSERT_EQ(restrip_mesh_play(made, view.records, view.record_count, 1, &done), RESTRIP_OK);
        EXPECT_EQ(done, view.record_count);
        EXPECT_EQ(sorted(corners_of(made)), sorted({soup.triangles.begin(), soup.triangles.end()}));
        if (view.record_count == 0) continue;
        EXPECT_EQ(restrip_mesh_play(made, view.records, view.record_count, 1, &done), RESTRIP_VERTEX_IN_USE);
        EXPECT_EQ(done, 0U);
        ASSERT_EQ(restrip_mesh_play(made, view.records, view.record_count, 0, nullptr), RESTRIP_OK);
        EXPECT_EQ(restrip_mesh_triangle_count(made), view.base_count / 3);

        // In steps the result is the same.
        Levels steps;
        ASSERT_EQ(input.simplify(SIZE_MAX, boundary, steps), RESTRIP_OK);
        EXPECT_EQ(view_of(steps).record_count, 0U);
        for (std::size_t left = 1; left != 0;) ASSERT_EQ(restrip_levels_run(steps.get(), wanted, 3, &left), RESTRIP_OK);
        expect_equal(view_of(steps), expected);
      }
}

TEST(CSimplify, WhatIsLeftOutIsCounted) {
  Input input(tools::sheet(4));
  input.indices.insert(input.indices.end(), {3, 3, 4});
  Levels levels;
  restrip_build_report report{};
  ASSERT_EQ(input.simplify(10, RESTRIP_BOUNDARY_MOVE, levels, nullptr, &report), RESTRIP_OK);
  EXPECT_EQ(report.degenerate_triangles, 1U);
  EXPECT_EQ(report.boundary_edges, 16U);
  EXPECT_LE(view_of(levels).base_count, 30U);
}

TEST(CSimplify, NothingIsLittle) {
  Levels levels;
  ASSERT_EQ(Input(Soup{}).simplify(0, RESTRIP_BOUNDARY_MOVE, levels), RESTRIP_OK);
  EXPECT_EQ(view_of(levels).base_count, 0U);
  EXPECT_EQ(view_of(levels).obstacle_count, 0U);
  restrip_levels_free(nullptr);
}

TEST(CSimplify, WrongArgumentsAreNamed) {
  const Input good(tools::sheet(4));
  const auto said = [](const Input& input, std::int32_t boundary = RESTRIP_BOUNDARY_MOVE) {
    Levels levels;
    std::string text;
    EXPECT_EQ(input.simplify(3, boundary, levels, &text), RESTRIP_BAD_ARGUMENT);
    return text;
  };
  for (const double wrong : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
                             -std::numeric_limits<double>::infinity()}) {
    Input input = good;
    input.points[23] = wrong;
    EXPECT_EQ(said(input), "a coordinate of vertex 7 is not a finite number");
  }
  Input input = good;
  input.indices[17] = 25;
  EXPECT_EQ(said(input), "triangle 5 has corner 25, but there are 25 vertices");
  input = good;
  input.indices.pop_back();
  EXPECT_EQ(said(input), "95 indices are not whole triangles");
  for (const std::int32_t wrong : {-1, 2})
    EXPECT_EQ(said(good, wrong), "boundary " + std::to_string(wrong) + " is neither 0 (lock) nor 1 (move)");

  // The text is cut off, or not wanted.
  char text[11];
  restrip_levels* made = nullptr;
  const auto simplify = [&](const std::uint32_t* indices, const double* points, std::size_t vertex_count, char* where,
                            std::size_t size, restrip_levels** out) {
    return restrip_simplify_u32(indices, good.indices.size(), points, vertex_count, 3, RESTRIP_BOUNDARY_MOVE, nullptr,
                                where, size, out);
  };
  const std::uint32_t* const indices = good.indices.data();
  const double* const points = good.points.data();
  EXPECT_EQ(simplify(indices, points, 3, text, sizeof text, &made), RESTRIP_BAD_ARGUMENT);
  EXPECT_STREQ(text, "triangle 0");
  EXPECT_EQ(simplify(indices, points, 3, nullptr, 0, &made), RESTRIP_BAD_ARGUMENT);
  // Neither read nor allocated.
  for (const std::size_t vertex_count : {std::size_t{RESTRIP_NONE}, std::numeric_limits<std::size_t>::max()})
    EXPECT_EQ(simplify(indices, points, vertex_count, nullptr, 0, &made), RESTRIP_TOO_LARGE);
  EXPECT_EQ(restrip_simplify_u32(indices, std::numeric_limits<std::size_t>::max() / 3 * 3, points, 25, 3,
                                 RESTRIP_BOUNDARY_MOVE, nullptr, nullptr, 0, &made),
            RESTRIP_TOO_LARGE);
  EXPECT_EQ(simplify(nullptr, points, 25, nullptr, 0, &made), RESTRIP_NULL_ARGUMENT);
  EXPECT_EQ(simplify(indices, nullptr, 25, nullptr, 0, &made), RESTRIP_NULL_ARGUMENT);
  EXPECT_EQ(simplify(indices, points, 25, nullptr, 7, &made), RESTRIP_NULL_ARGUMENT);
  EXPECT_EQ(simplify(indices, points, 25, nullptr, 0, nullptr), RESTRIP_NULL_ARGUMENT);
  EXPECT_EQ(made, nullptr);
  restrip_levels_view view{};
  EXPECT_EQ(restrip_levels_read(nullptr, &view), RESTRIP_NULL_ARGUMENT);
  Levels levels;
  ASSERT_EQ(good.simplify(3, RESTRIP_BOUNDARY_MOVE, levels), RESTRIP_OK);
  EXPECT_EQ(restrip_levels_read(levels.get(), nullptr), RESTRIP_NULL_ARGUMENT);
}

TEST(CSimplify, MemoryMayRunOut) {
  const Input input(tools::sheet(4));
  restrip_status status = RESTRIP_OK;
  Levels levels;
  std::size_t short_of = 0;
  testing_support::for_each_allocation(
      [&] {
        restrip_levels* made = nullptr;
        status = restrip_simplify_u32(input.indices.data(), input.indices.size(), input.points.data(), 25, 1,
                                      RESTRIP_BOUNDARY_LOCK, nullptr, nullptr, 0, &made);
        levels.reset(made);
      },
      [&] {
        // A sort does without the memory that it would like.
        EXPECT_TRUE(status == RESTRIP_OUT_OF_MEMORY || status == RESTRIP_OK) << restrip_describe(status);
        EXPECT_EQ(levels == nullptr, status == RESTRIP_OUT_OF_MEMORY);
        if (status == RESTRIP_OUT_OF_MEMORY) ++short_of;
      });
  EXPECT_EQ(status, RESTRIP_OK);
  EXPECT_GT(view_of(levels).obstacle_count, 0U);
  EXPECT_GT(short_of, 10U);
}

}  // namespace
}  // namespace restrip::c_test
