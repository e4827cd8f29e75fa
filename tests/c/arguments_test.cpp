// No argument ends the program: null pointers, numbers out of range and arrays that are too short return codes, each
// with a text, and leave the mesh unchanged. tests/python sets invalid colours.
#include <algorithm>
#include <limits>
#include <set>
#include <string>
#include <utility>

#include "handle.hpp"
#include "restrip/search/policy.hpp"
#include "runtime/sample_meshes.hpp"

namespace restrip::c_test {
namespace {

// The code of a policy never changes: a program that was compiled before a policy was added continues to work.
static_assert(RESTRIP_POLICY_BARE == 0 && RESTRIP_POLICY_RULES == 1 && RESTRIP_POLICY_LOCAL == 2);
static_assert(RESTRIP_POLICY_QUICK == 3 && RESTRIP_POLICY_FULL == 4);
constexpr std::int32_t policy_codes = policies.size();

TEST(CArguments, NullIsACode) {
  const Handle mesh = handle_of(sample::octahedron());
  restrip_mesh* const m = mesh.get();
  restrip_mesh* made = m;
  std::uint32_t number = 0;
  std::uint32_t corners[3];
  std::uint8_t byte = 0;
  std::size_t size = 0;
  const void* data = nullptr;
  const float* points = nullptr;
  const restrip_range* ranges = nullptr;
  restrip_buffer_view view{};
  std::int32_t done = 0;
  const restrip_status codes[] = {restrip_mesh_build_u32(nullptr, 3, 3, nullptr, nullptr, &made),
                                  restrip_mesh_build_u32(&number, 3, 3, nullptr, nullptr, nullptr),
                                  restrip_mesh_build_u16(nullptr, 3, 3, nullptr, nullptr, &made),
                                  restrip_mesh_corners(nullptr, 0, corners),
                                  restrip_mesh_corners(m, 0, nullptr),
                                  restrip_mesh_get_colors(nullptr, &byte, 1),
                                  restrip_mesh_get_colors(m, nullptr, 8),
                                  restrip_mesh_set_colors(nullptr, &byte, 1),
                                  restrip_mesh_set_colors(m, nullptr, 8),
                                  restrip_mesh_check(nullptr, nullptr),
                                  restrip_mesh_check(m, nullptr),
                                  restrip_mesh_strip_count(nullptr, &size),
                                  restrip_mesh_strip_count(m, nullptr),
                                  restrip_mesh_stripify(nullptr, 0, nullptr, 0, nullptr),
                                  restrip_mesh_keep(nullptr, 0, nullptr),
                                  restrip_mesh_split(nullptr, 0, 1, RESTRIP_NONE, nullptr),
                                  restrip_mesh_collapse(nullptr, 0, nullptr),
                                  restrip_mesh_flip(nullptr, 0, nullptr),
                                  restrip_mesh_check_split(nullptr, 0, 1, RESTRIP_NONE),
                                  restrip_mesh_find_each(nullptr, 0, nullptr, nullptr, nullptr),
                                  restrip_mesh_find_each(m, 1, nullptr, corners, corners),
                                  restrip_mesh_find_each(m, 1, corners, nullptr, corners),
                                  restrip_mesh_find_each(m, 1, corners, corners, nullptr),
                                  restrip_mesh_check_each(nullptr, RESTRIP_FLIP, 0, nullptr, nullptr),
                                  restrip_mesh_check_each(m, RESTRIP_FLIP, 1, nullptr, &done),
                                  restrip_mesh_check_each(m, RESTRIP_FLIP, 1, corners, nullptr),
                                  restrip_mesh_apply_each(nullptr, RESTRIP_FLIP, 0, nullptr, nullptr, nullptr),
                                  restrip_mesh_apply_each(m, RESTRIP_FLIP, 1, nullptr, &done, nullptr),
                                  restrip_mesh_apply_each(m, RESTRIP_FLIP, 1, corners, nullptr, nullptr),
                                  restrip_mesh_split_face(nullptr, 0, nullptr),
                                  restrip_mesh_join_faces(nullptr, 0, nullptr),
                                  restrip_mesh_bisect(nullptr, 0, nullptr),
                                  restrip_mesh_merge(nullptr, 0, nullptr),
                                  restrip_mesh_improve(nullptr, 1, nullptr),
                                  restrip_mesh_strips(nullptr, &number, 1, &size, 1),
                                  restrip_mesh_strips(m, nullptr, 1, &size, 1),
                                  restrip_mesh_triangles(nullptr, &number, 1),
                                  restrip_mesh_triangles(m, nullptr, 1),
                                  restrip_mesh_copy(nullptr, &made),
                                  restrip_mesh_copy(m, nullptr),
                                  restrip_mesh_reserve(nullptr, 1, 1),
                                  restrip_mesh_play(nullptr, nullptr, 0, 1, nullptr),
                                  restrip_mesh_play(m, nullptr, 1, 1, nullptr),
                                  restrip_live_begin(nullptr, nullptr, nullptr, 0),
                                  restrip_live_update(nullptr, 2, 4, &ranges, &size, nullptr),
                                  restrip_live_update(m, 2, 4, nullptr, &size, nullptr),
                                  restrip_live_update(m, 2, 4, &ranges, nullptr, nullptr),
                                  restrip_live_buffer(nullptr, &view, &size),
                                  restrip_live_buffer(m, nullptr, &size),
                                  restrip_live_undo(nullptr, &done),
                                  restrip_live_undo(m, nullptr),
                                  restrip_live_redo(nullptr, &done),
                                  restrip_live_redo(m, nullptr),
                                  restrip_live_history_size(nullptr, &size, &size),
                                  restrip_live_history_size(m, nullptr, &size),
                                  restrip_live_history_size(m, &size, nullptr),
                                  restrip_mesh_save(nullptr, &data, &size),
                                  restrip_mesh_save(m, nullptr, &size),
                                  restrip_mesh_save(m, &data, nullptr),
                                  restrip_mesh_load(nullptr, 1, 0, nullptr, 0, &made),
                                  restrip_mesh_load(&number, 4, 0, nullptr, 0, nullptr),
                                  restrip_mesh_load(&number, 4, 0, nullptr, 1, &made),
                                  restrip_baked_read(nullptr, 1, nullptr, 0, &made),
                                  restrip_baked_read(&number, 4, nullptr, 0, nullptr),
                                  restrip_baked_read(&number, 4, nullptr, 1, &made),
                                  restrip_baked_level(nullptr, &size),
                                  restrip_baked_level(m, nullptr),
                                  restrip_baked_move(nullptr, 0, 1, nullptr),
                                  restrip_baked_restart(nullptr),
                                  restrip_baked_record(nullptr, 0, nullptr),
                                  restrip_baked_record(m, 0, nullptr),
                                  restrip_baked_payload(nullptr, 0, &data, &size),
                                  restrip_baked_payload(m, 0, nullptr, &size),
                                  restrip_baked_payload(m, 0, &data, nullptr),
                                  restrip_baked_points(nullptr, &points, &size),
                                  restrip_baked_points(m, nullptr, &size),
                                  restrip_baked_points(m, &points, nullptr),
                                  restrip_lookup(RESTRIP_RULE_SPLIT, 4, 2, 0, 0, 0, nullptr)};
  for (std::size_t i = 0; i < std::size(codes); ++i) EXPECT_EQ(codes[i], RESTRIP_NULL_ARGUMENT) << "call " << i;
  EXPECT_EQ(made, nullptr);
  // Functions that return a number return RESTRIP_NONE.
  restrip_mesh_free(nullptr);
  EXPECT_EQ(restrip_mesh_triangle_count(nullptr) + restrip_mesh_triangle_bound(nullptr) +
                restrip_mesh_vertex_bound(nullptr) + restrip_baked_levels(nullptr),
            0U);
  EXPECT_EQ(restrip_mesh_solid(nullptr, 0), 0);
  EXPECT_EQ(restrip_mesh_policy(nullptr), RESTRIP_POLICY_BARE);
  for (const auto walk : {restrip_mesh_next, restrip_mesh_opposite, restrip_mesh_from, restrip_mesh_to,
                          restrip_mesh_triangle, restrip_mesh_spoke}) {
    EXPECT_EQ(walk(nullptr, 0), RESTRIP_NONE);
    EXPECT_EQ(walk(m, RESTRIP_NONE), RESTRIP_NONE);
    EXPECT_EQ(walk(m, 8 * 4), RESTRIP_NONE);
  }
  EXPECT_EQ(restrip_mesh_find(nullptr, 0, 1), RESTRIP_NONE);
  EXPECT_EQ(restrip_mesh_find(m, 0, 6), RESTRIP_NONE);
  EXPECT_EQ(restrip_mesh_find(m, 6, 0), RESTRIP_NONE);
  EXPECT_EQ(restrip_mesh_find(m, 0, 1), RESTRIP_NONE);  // poles
}

TEST(CArguments, NumbersOutOfRangeAreCodes) {
  const Handle mesh = handle_of(sample::rectangle(4, 4));
  restrip_mesh* const m = mesh.get();
  const auto before = colors_of(m);
  std::size_t size = 0;
  std::uint32_t corners[3];
  restrip_mesh* made = m;
  const std::uint32_t four[] = {0, 1, 2, 0};
  constexpr std::int32_t lowest = std::numeric_limits<std::int32_t>::min();
  constexpr std::int32_t highest = std::numeric_limits<std::int32_t>::max();
  EXPECT_EQ(restrip_mesh_build_u32(four, 4, 3, nullptr, nullptr, &made), RESTRIP_BAD_ARGUMENT);
  EXPECT_EQ(made, nullptr);
  EXPECT_EQ(restrip_mesh_corners(m, 32, corners), RESTRIP_BAD_ARGUMENT);
  for (const std::int32_t wrong : {lowest, -1, 3, highest})
    EXPECT_EQ(restrip_mesh_stripify(m, wrong, nullptr, 0, nullptr), RESTRIP_BAD_ARGUMENT);
  for (const std::int32_t wrong : {lowest, -1, int{RESTRIP_POLICY_BAKED}, policy_codes, highest})
    EXPECT_EQ(restrip_mesh_keep(m, wrong, nullptr), RESTRIP_BAD_ARGUMENT);
  for (const std::int32_t wrong : {lowest, -1, 4, highest}) EXPECT_EQ(begin_live(m, wrong, 32), RESTRIP_BAD_ARGUMENT);
  for (const restrip_cost wrong : {restrip_cost{0, 1, 0}, {1001, 0, 0}, {1, 1001, 0}, {1, 0, 65535}}) {
    EXPECT_EQ(restrip_mesh_stripify(m, 0, &wrong, 0, nullptr), RESTRIP_BAD_ARGUMENT);
    EXPECT_EQ(restrip_mesh_keep(m, RESTRIP_POLICY_LOCAL, &wrong), RESTRIP_BAD_ARGUMENT);
  }
  EXPECT_EQ(restrip_mesh_policy(m), RESTRIP_POLICY_QUICK);
  // Without baked levels.
  const void* data = nullptr;
  const float* points = nullptr;
  restrip_record record{};
  EXPECT_EQ(restrip_baked_level(m, &size), RESTRIP_NOT_BAKED);
  EXPECT_EQ(restrip_baked_move(m, 0, 1, nullptr), RESTRIP_NOT_BAKED);
  EXPECT_EQ(restrip_baked_restart(m), RESTRIP_NOT_BAKED);
  EXPECT_EQ(restrip_baked_record(m, 0, &record), RESTRIP_NOT_BAKED);
  EXPECT_EQ(restrip_baked_payload(m, 0, &data, &size), RESTRIP_NOT_BAKED);
  EXPECT_EQ(restrip_baked_points(m, &points, &size), RESTRIP_NOT_BAKED);
  EXPECT_EQ(colors_of(m), before);
}

TEST(CArguments, ShortArraysAreLeftAlone) {
  const Handle mesh = handle_of(sample::sphere(1));
  ASSERT_EQ(restrip_mesh_stripify(mesh.get(), RESTRIP_EFFORT_FAST, &fewest_strips, 0, nullptr), RESTRIP_OK);
  std::vector<std::uint32_t> cells(restrip_mesh_triangle_count(mesh.get()) - 1, 777);
  std::vector<std::size_t> starts(strip_count(mesh.get()) + 1, 777);
  EXPECT_EQ(restrip_mesh_strips(mesh.get(), cells.data(), cells.size(), starts.data(), starts.size()),
            RESTRIP_TOO_SMALL);
  EXPECT_EQ(std::count(cells.begin(), cells.end(), 777U), static_cast<std::ptrdiff_t>(cells.size()));
  EXPECT_EQ(restrip_mesh_triangles(mesh.get(), cells.data(), cells.size()), RESTRIP_TOO_SMALL);
  std::uint8_t byte = 7;
  EXPECT_EQ(restrip_mesh_get_colors(mesh.get(), &byte, 1), RESTRIP_TOO_SMALL);
  EXPECT_EQ(byte, 7);
}

TEST(CArguments, WhatIsLeftOutIsReported) {
  const std::uint16_t indices[] = {0, 1, 2, 2, 1, 3, 4, 4, 1, 0, 1, 9};
  restrip_build_report report{};
  std::uint32_t origin[4] = {77, 77, 77, 77};
  restrip_mesh* made = nullptr;
  ASSERT_EQ(restrip_mesh_build_u16(indices, 12, 5, &report, origin, &made), RESTRIP_OK);
  const Handle mesh(made);
  EXPECT_EQ(restrip_mesh_triangle_count(made), 2U);
  EXPECT_EQ(report.degenerate_triangles, 1U);
  EXPECT_EQ(report.out_of_range_triangles, 1U);
  EXPECT_EQ(report.boundary_edges, 4U);
  EXPECT_EQ(std::vector<std::uint32_t>(origin, origin + 4), (std::vector<std::uint32_t>{0, 1, 77, 77}));
  restrip_mesh* empty = nullptr;
  ASSERT_EQ(restrip_mesh_build_u32(nullptr, 0, 0, nullptr, nullptr, &empty), RESTRIP_OK);
  const Handle nothing(empty);
  EXPECT_EQ(strip_count(empty), 0U);
}

TEST(CArguments, EveryCodeHasATextOfItsOwn) {
  const std::string unknown = restrip_describe(-7);
  std::set<std::string> texts;
  for (const auto& [first, last] : {std::pair{0, 16}, {100, 109}})
    for (restrip_status status = first; status <= last; ++status) {
      texts.insert(restrip_describe(status));
      EXPECT_NE(restrip_describe(status), unknown) << status;
    }
  EXPECT_EQ(texts.size(), 27U);
  for (const restrip_status status : {17, 99, 110, std::numeric_limits<restrip_status>::min()})
    EXPECT_EQ(restrip_describe(status), unknown);
  EXPECT_EQ(restrip_abi_version(), std::uint32_t{RESTRIP_ABI_VERSION});
  EXPECT_FALSE(std::string(restrip_version()).empty());
}

}  // namespace
}  // namespace restrip::c_test
