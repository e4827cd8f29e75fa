// A baked mesh played through the C interface has, at every level, the triangles, colours and indices that the
// library's player has there, whether the level is reached by splits or by collapses. Damaged bytes give a code and the
// reader's text. Any other operation leaves the levels, and restarting returns to them.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <limits>
#include <random>
#include <span>
#include <string>

#include "handle.hpp"
#include "lod/bake.hpp"
#include "lod/baked_file.hpp"
#include "lod/simplify.hpp"
#include "meshes/made_mesh.hpp"
#include "restrip/formats/baked_file.hpp"
#include "support/failing_new.hpp"
#include "tools/shapes.hpp"

namespace restrip::c_test {
namespace {

using testing_support::for_each_allocation;

std::string bytes_of(const tools::Soup& soup) {
  return tools::baked_bytes(tools::bake(tools::simplify(soup, {0.2, tools::BoundaryPolicy::move}).mesh, {20'000}));
}

Handle read(const std::string& bytes) {
  restrip_mesh* mesh = nullptr;
  char text[8];
  EXPECT_EQ(restrip_baked_read(bytes.data(), bytes.size(), text, sizeof text, &mesh), RESTRIP_OK);
  EXPECT_STREQ(text, "");
  return Handle(mesh);
}

TEST(CBaked, EveryLevelIsThatOfTheLibrary) {
  std::mt19937 random(19);
  for (const tools::Soup& soup : {tools::make_mesh(600), tools::sheet(12)}) {
    const std::string bytes = bytes_of(soup);
    BakedFile file;
    ASSERT_EQ(read_baked(std::as_bytes(std::span(bytes)), file), "");
    std::vector<std::vector<std::array<std::uint32_t, 3>>> corners;
    std::vector<std::vector<std::uint8_t>> colors;
    StripMesh played = file.mesh;
    for (std::size_t i = 0;; ++i) {
      corners.push_back(corners_of(played));
      colors.push_back(colors_of(played));
      if (i == file.splits.size()) break;
      split_baked(played, spokes_of(played, file.splits[i]), file.records[i], file.splits[i].v_t);
    }
    const Handle mesh = read(bytes);
    restrip_mesh* const m = mesh.get();
    ASSERT_EQ(restrip_baked_levels(m), file.splits.size());
    ASSERT_EQ(restrip_mesh_policy(m), RESTRIP_POLICY_BAKED);
    std::size_t level = 1;
    ASSERT_EQ(restrip_baked_level(m, &level), RESTRIP_OK);
    ASSERT_EQ(level, 0U);
    for (int n = 0; n < 60; ++n) {
      const std::size_t wanted = n == 0 ? 0 : n == 1 ? file.splits.size() : random() % corners.size();
      const std::size_t most = n % 5 == 4 ? random() % 20 : SIZE_MAX;
      const std::size_t way = wanted > level ? wanted - level : level - wanted;
      const std::size_t expected = wanted > level ? level + std::min(way, most) : level - std::min(way, most);
      std::size_t done = 0;
      ASSERT_EQ(restrip_baked_move(m, wanted, most, &done), RESTRIP_OK);
      ASSERT_EQ(done, std::min(way, most));
      ASSERT_EQ(restrip_baked_level(m, &level), RESTRIP_OK);
      ASSERT_EQ(level, expected);
      // Removed triangles leave unused numbers.
      auto now = corners_of(m);
      auto painted = colors_of(m);
      for (std::size_t t = corners[level].size(); t < now.size(); ++t) ASSERT_EQ(now[t][0], RESTRIP_NONE);
      now.resize(corners[level].size());
      painted.resize(colors[level].size());
      ASSERT_EQ(now, corners[level]);
      ASSERT_EQ(painted, colors[level]);
      ASSERT_EQ(strip_count(m), counted(m).strips);
    }
    const float* points = nullptr;
    std::size_t vertices = 0;
    ASSERT_EQ(restrip_baked_points(m, &points, &vertices), RESTRIP_OK);
    ASSERT_EQ(vertices, file.points.size());
    for (std::size_t i = 0; i < vertices; ++i) ASSERT_EQ(points[3 * i + 2], file.points[i][2]);
    restrip_record record{};
    ASSERT_EQ(restrip_baked_record(m, file.splits.size() - 1, &record), RESTRIP_OK);
    EXPECT_EQ(record.v_t, file.splits.back().v_t);
    EXPECT_EQ(record.v_l, file.splits.back().v_l);
    EXPECT_EQ(restrip_baked_record(m, file.splits.size(), &record), RESTRIP_BAD_ARGUMENT);
    EXPECT_EQ(restrip_baked_move(m, file.splits.size() + 1, 1, nullptr), RESTRIP_BAD_ARGUMENT);
    EXPECT_EQ(restrip_mesh_improve(m, 10, nullptr), RESTRIP_BAD_ARGUMENT);  // it would leave the baked level
  }
}

TEST(CBaked, AnOperationLeavesTheLevelsUntilTheMeshRestarts) {
  const Handle mesh = read(bytes_of(tools::make_mesh(400)));
  restrip_mesh* const m = mesh.get();
  const auto base = colors_of(m);
  ASSERT_EQ(begin_live(m, RESTRIP_FORM_LIST, 32), RESTRIP_OK);
  ASSERT_EQ(restrip_baked_move(m, 50, SIZE_MAX, nullptr), RESTRIP_OK);
  ASSERT_EQ(restrip_mesh_flip(m, RESTRIP_NONE, nullptr), RESTRIP_NO_SUCH_EDGE);  // a refused one leaves nothing
  std::size_t level = 0;
  ASSERT_EQ(restrip_baked_level(m, &level), RESTRIP_OK);
  ASSERT_EQ(restrip_mesh_bisect(m, restrip_mesh_spoke(m, 3), nullptr), RESTRIP_OK);
  EXPECT_EQ(restrip_baked_level(m, &level), RESTRIP_OUT_OF_STEP);
  EXPECT_EQ(restrip_baked_move(m, 60, SIZE_MAX, nullptr), RESTRIP_OUT_OF_STEP);
  EXPECT_EQ(strip_count(m), counted(m).strips);
  ASSERT_EQ(restrip_baked_restart(m), RESTRIP_OK);
  EXPECT_EQ(restrip_mesh_policy(m), RESTRIP_POLICY_BAKED);
  EXPECT_EQ(colors_of(m), base);
  const auto ranges = updated(m);
  ASSERT_EQ(ranges.size(), 1U);  // the whole buffer
  EXPECT_EQ(ranges[0].count, 3 * restrip_mesh_triangle_count(m));
}

TEST(CBaked, DamageIsACodeAndAText) {
  const std::string bytes = bytes_of(tools::sheet(6)).substr(0, 100);
  BakedFile file;
  const std::string fault = read_baked(std::as_bytes(std::span(bytes)), file);
  restrip_mesh* mesh = nullptr;
  for (const std::size_t room : {0U, 1U, 7U}) {  // the text is cut off, or not wanted
    std::string text(20, 'x');
    ASSERT_EQ(restrip_baked_read(bytes.data(), bytes.size(), room == 0 ? nullptr : text.data(), room, &mesh),
              RESTRIP_BAD_FILE);
    ASSERT_EQ(mesh, nullptr);
    EXPECT_EQ(text, room == 0 ? text : fault.substr(0, room - 1) + '\0' + std::string(20 - room, 'x'));
  }
}

TEST(CBaked, APayloadIsHandedOut) {
  const std::string plain = bytes_of(tools::sheet(6));
  const auto raw = std::as_bytes(std::span(plain));
  std::vector<std::byte> bytes(raw.begin(), raw.end());
  const std::size_t records = restrip_baked_levels(read(plain).get());
  std::vector<std::byte> payload;
  for (std::size_t i = 0; i < 3 * records; ++i) payload.push_back(static_cast<std::byte>(i & 255U));
  ASSERT_EQ(set_payload(bytes, payload), "");
  const Handle mesh = read({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  const void* data = nullptr;
  std::size_t size = 0;
  for (std::size_t i = 0; i < records; ++i) {
    ASSERT_EQ(restrip_baked_payload(mesh.get(), i, &data, &size), RESTRIP_OK);
    ASSERT_EQ(size, 3U);
    ASSERT_EQ(std::memcmp(data, payload.data() + 3 * i, 3), 0);
  }
  EXPECT_EQ(restrip_baked_payload(mesh.get(), records, &data, &size), RESTRIP_BAD_ARGUMENT);
  ASSERT_EQ(restrip_baked_payload(read(plain).get(), 0, &data, &size), RESTRIP_OK);
  EXPECT_EQ(size, 0U);
}

TEST(CBaked, MemoryMayRunOut) {
  const std::string bytes = bytes_of(tools::sheet(6));
  restrip_mesh* made = nullptr;
  restrip_status status = RESTRIP_OK;
  for_each_allocation([&] { status = restrip_baked_read(bytes.data(), bytes.size(), nullptr, 0, &made); },
                      [&] {
                        ASSERT_EQ(status, RESTRIP_OUT_OF_MEMORY);
                        ASSERT_EQ(made, nullptr);
                      });
  ASSERT_EQ(status, RESTRIP_OK);
  const Handle mesh(made);
  // Room for all levels was taken when it was read; a watch takes more.
  ASSERT_EQ(begin_live(made, RESTRIP_FORM_RESTART, 32), RESTRIP_OK);
  updated(made);
  std::size_t failures = 0;
  for_each_allocation([&] { status = restrip_baked_move(made, restrip_baked_levels(made), SIZE_MAX, nullptr); },
                      [&] {
                        ++failures;
                        ASSERT_EQ(status, RESTRIP_OUT_OF_MEMORY);
                        ASSERT_EQ(restrip_baked_move(made, 0, SIZE_MAX, nullptr), RESTRIP_OUT_OF_STEP);
                        ASSERT_EQ(strip_count(made), counted(made).strips);
                        ASSERT_EQ(restrip_baked_restart(made), RESTRIP_OK);
                        ASSERT_EQ(begin_live(made, RESTRIP_FORM_RESTART, 32), RESTRIP_OK);
                        updated(made);
                      });
  ASSERT_EQ(status, RESTRIP_OK);
  EXPECT_GT(failures, 2U);
}

// ---- simplification
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

  char text[11];
  restrip_levels* made = nullptr;
  const auto simplify = [&](const double* points, std::size_t vertex_count, char* where, restrip_levels** out) {
    return restrip_simplify_u32(good.indices.data(), good.indices.size(), points, vertex_count, 3,
                                RESTRIP_BOUNDARY_MOVE, nullptr, where, sizeof text, out);
  };
  const double* const points = good.points.data();
  EXPECT_EQ(simplify(points, 3, text, &made), RESTRIP_BAD_ARGUMENT);
  EXPECT_STREQ(text, "triangle 0");  // cut off
  // Neither read nor allocated.
  for (const std::size_t vertex_count : {std::size_t{RESTRIP_NONE}, std::numeric_limits<std::size_t>::max()})
    EXPECT_EQ(simplify(points, vertex_count, text, &made), RESTRIP_TOO_LARGE);
  EXPECT_EQ(simplify(nullptr, 25, text, &made), RESTRIP_NULL_ARGUMENT);
  EXPECT_EQ(simplify(points, 25, nullptr, &made), RESTRIP_NULL_ARGUMENT);
  EXPECT_EQ(simplify(points, 25, text, nullptr), RESTRIP_NULL_ARGUMENT);
  EXPECT_EQ(made, nullptr);
  restrip_levels_view view{};
  EXPECT_EQ(restrip_levels_read(nullptr, &view), RESTRIP_NULL_ARGUMENT);
  restrip_levels_free(nullptr);
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
