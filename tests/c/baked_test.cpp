// A baked mesh played through the C interface has, at every level, the triangles, colours and indices that the
// library's player has there, whether the level is reached by splits or by collapses. Damaged bytes give a code and the
// reader's text. Any other operation leaves the levels, and restarting returns to them.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <random>
#include <span>
#include <string>
#include <vector>

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

}  // namespace
}  // namespace restrip::c_test
