// Claims: OpenMesh's progressive meshes are read with their original orientation, a written file reads back unchanged,
// and no other file is taken for one.
#include "lod/pm_file.hpp"

#include <gtest/gtest.h>

#include "common/reading.hpp"
#include "lod/simplify.hpp"
#include "meshes/made_mesh.hpp"
#include "real_meshes.hpp"
#include "replay/methods.hpp"
#include "replay/replay.hpp"
#include "shapes.hpp"
#include "support/refusal_of.hpp"

namespace restrip::tools {
namespace {

std::string pm_refusal(std::string_view bytes) {
  return refusal_of([&] { (void)parse_pm(bytes, "some.pm"); });
}

TEST(PmFile, WhatIsWrittenIsRead) {
  for (const Soup& soup : {make_mesh(1000), sheet(15)}) {
    const ProgressiveMesh mesh = simplify(soup, {0.05, BoundaryPolicy::move}).mesh;
    const std::string bytes = pm_bytes(mesh);
    const ProgressiveMesh again = parse_pm(bytes, "some.pm");
    EXPECT_EQ(again.base.size(), mesh.base.size());
    EXPECT_EQ(again.splits.size(), mesh.splits.size());
    EXPECT_EQ(again.fine_triangles(), soup.triangles.size());
    // A mesh numbered in order of appearance stays as it is.
    EXPECT_EQ(pm_bytes(again), bytes);
    const ReplayReport report = replay(PreparedMethod("local", again), {}, {2, 0, 0});
    EXPECT_TRUE(report.valid());
    EXPECT_EQ(report.operations_without_rule, 0U);
  }
}

TEST(PmFile, RefusesWhatItIsNot) {
  const std::string whole = pm_bytes(simplify(make_mesh(200), {0.2, BoundaryPolicy::move}).mesh);
  EXPECT_EQ(pm_refusal(whole), "");
  EXPECT_NE(pm_refusal("").find("begins neither with 'ProgMesh'"), std::string::npos);
  EXPECT_NE(pm_refusal("# a mesh\n# by hand\nPM\nversion=2\n").find("ends inside its header"), std::string::npos);
  EXPECT_NE(pm_refusal(whole.substr(0, 12)).find("ends inside its header"), std::string::npos);
  EXPECT_NE(pm_refusal(whole.substr(0, whole.size() - 1)).find("is it complete?"), std::string::npos);
  std::string wrong = whole;
  wrong[wrong.size() - 10] = '\x7F';  // the last split names a missing vertex
  EXPECT_NE(pm_refusal(wrong).find("refers to vertices"), std::string::npos);
}

TEST(PmFile, NothingToReplayIsAnError) {
  const auto base_of = [](const std::vector<Corners>& base) {
    ProgressiveMesh mesh;
    mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.base = base;
    return pm_bytes(mesh);
  };
  EXPECT_EQ(pm_refusal(base_of({{0, 1, 2}})), "");
  EXPECT_NE(pm_refusal(base_of({})).find("no triangles"), std::string::npos);
  EXPECT_NE(pm_refusal(base_of({{0, 1, 1}, {2, 1, 2}})).find("degenerate"), std::string::npos);
  EXPECT_EQ(pm_refusal(base_of({{0, 1, 1}, {0, 1, 2}})), "");  // one is left out and counted, the other replayed
}

TEST(PmFile, RealOne) {
  const auto file = REAL_MESH("om_bunny.pm");
  const ProgressiveMesh mesh = parse_pm(files::read_whole(file), file.string());
  EXPECT_EQ(mesh.base.size(), 694U);
  EXPECT_EQ(mesh.splits.size(), 34486U);
  const ReplayReport report = replay(PreparedMethod("local", mesh), {}, {2, 0, 1});
  EXPECT_TRUE(report.valid());
  EXPECT_EQ(report.triangles, 69666U);
  EXPECT_EQ(report.operations_without_rule, 0U);
  EXPECT_EQ(report.operations_isolating, 0U);
  std::vector<std::size_t> valences(19, 0);
  for (const auto& [k, n] : {std::pair{3U, 1U},
                             {4U, 106U},
                             {5U, 1800U},
                             {6U, 7335U},
                             {7U, 12439U},
                             {8U, 9506U},
                             {9U, 2601U},
                             {10U, 607U},
                             {11U, 79U},
                             {12U, 11U},
                             {18U, 1U}})
    valences[k] = n;
  EXPECT_EQ(report.by_valence, valences);
}

TEST(PmFile, TheOtherOrientationDoesNotFit) {
  const auto file = REAL_MESH("om_bunny.pm");
  ProgressiveMesh mesh = parse_pm(files::read_whole(file), file.string());
  for (Record& record : mesh.splits) std::swap(record.v_l, record.v_r);
  EXPECT_GT(replay(PreparedMethod("local", mesh), {}, {2, 0, 0}).operations_without_rule, 0U);
}

// The counts are in the file's own header.
TEST(PmFile, HoppesIsReadAndReplayed) {
  const auto file = REAL_MESH("hoppe_standingblob.pm");
  const ProgressiveMesh mesh = parse_pm(files::read_whole(file), file.string());
  EXPECT_EQ(mesh.points.size(), 11'676U);
  EXPECT_EQ(mesh.splits.size(), 11'672U);
  EXPECT_EQ(mesh.fine_triangles(), 23'348U);
  const ReplayReport report = replay(PreparedMethod("local", mesh), {}, {2, 0, 0});
  EXPECT_EQ(report.operations_without_rule, 0U);
  EXPECT_TRUE(report.valid());
}

}  // namespace
}  // namespace restrip::tools
