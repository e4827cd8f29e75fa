// Claims: files of levels read back unchanged, including mesh and strips; truncated, altered or other-version files are
// refused; a baked file built to deceive is refused or at least is a mesh. User payload is stored as
// docs/reference/file-formats.md says and returned record by record. OpenMesh's progressive meshes are read with their
// original orientation, and no other file is taken for one.
#include <gtest/gtest.h>

#include <map>
#include <random>

#include "common/reading.hpp"
#include "folders.hpp"
#include "lod/baked_file.hpp"
#include "lod/pm_file.hpp"
#include "lod/simplify.hpp"
#include "meshes/little_endian.hpp"
#include "meshes/made_mesh.hpp"
#include "replay/methods.hpp"
#include "replay/replay.hpp"
#include "restrip/formats/baked_file.hpp"
#include "shapes.hpp"
#include "support/refusal_of.hpp"

namespace restrip::tools {
namespace {

BakedMesh small(const Soup& soup, double base) {
  return bake(simplify(soup, {base, BoundaryPolicy::move}).mesh, {20'000});
}

std::string refusal(std::string_view bytes) {
  return refusal_of([&] { (void)parse_baked(bytes, "some.baked"); });
}

std::string with_checksum(std::string bytes) {
  bytes.resize(bytes.size() - 8);
  const std::uint64_t hash = fnv1a(bytes);
  put(bytes, static_cast<std::uint32_t>(hash));
  put(bytes, static_cast<std::uint32_t>(hash >> 32));
  return bytes;
}

/// The number of records, as the header has it.
std::size_t records_of(const std::string& bytes) { return little_endian(bytes, 20); }

std::vector<std::byte> as_vector(std::string_view bytes) {
  const auto all = std::as_bytes(std::span(bytes));
  return {all.begin(), all.end()};
}
std::string as_string(const std::vector<std::byte>& bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// The file with N bytes for each record: 0, 1, 2, …
std::string with_payload(const std::string& bytes, std::size_t each) {
  std::vector<std::byte> payload(records_of(bytes) * each);
  for (std::size_t i = 0; i < payload.size(); ++i) payload[i] = static_cast<std::byte>(i & 255U);
  std::vector<std::byte> file = as_vector(bytes);
  EXPECT_EQ(set_payload(file, payload), "");
  return as_string(file);
}

TEST(BakedFile, APayloadThatDoesNotFitIsRefused) {
  const std::string plain = baked_bytes(small(sheet(7), 0.3));
  const std::size_t records = records_of(plain);
  ASSERT_GT(records, 2U);
  std::vector<std::byte> file = as_vector(plain);
  for (const std::size_t size : {std::size_t{1}, records - 1, records + 1, 5 * records - 1})
    EXPECT_NE(set_payload(file, std::vector<std::byte>(size)).find("records"), std::string::npos) << size;
  std::string broken = plain;
  broken[30] ^= 1;
  std::vector<std::byte> altered = as_vector(broken);
  EXPECT_NE(set_payload(altered, std::vector<std::byte>(records)).find("checksum"), std::string::npos);
  EXPECT_EQ(as_string(file) + as_string(altered), plain + broken);
  // A header that announces more, or less, than the file has.
  const std::string loaded = with_payload(plain, 4);
  for (const auto& [said, text] : std::map<std::uint32_t, std::string>{{0, "after its last record"},
                                                                       {3, "after its last record"},
                                                                       {5, "too early"},
                                                                       {1U << 20, "announces more"},
                                                                       {0xFFFFFFFF, "announces more"}}) {
    std::string forged = loaded.substr(0, 24);
    put(forged, said);
    const std::string reported = refusal(with_checksum(forged + loaded.substr(28)));
    EXPECT_TRUE(reported.find(text) != std::string::npos || reported.find("record") != std::string::npos) << reported;
    EXPECT_NE(reported, "");
  }
}

TEST(BakedFile, WhatIsWrittenIsRead) {
  for (const Soup& soup : {make_mesh(1500), sheet(18), tetrahedron()}) {
    const BakedMesh baked = small(soup, 0.05);
    const std::string bytes = baked_bytes(baked);
    const BakedMesh again = parse_baked(bytes, "some.baked");
    // The same progressive mesh, with its vertices in order of appearance.
    EXPECT_EQ(pm_bytes(again.mesh), pm_bytes(baked.mesh));
    EXPECT_EQ(baked_bytes(again), bytes);
    const Method& method = method_named("baked");
    const ReplayReport first = replay({method, baked.mesh, {.baked = &baked}}, soup.triangles, {.repeats = 0});
    const ReplayReport second = replay({method, again.mesh, {.baked = &again}}, {}, {.repeats = 0});
    EXPECT_TRUE(first.valid());
    EXPECT_TRUE(second.valid());
    ASSERT_EQ(first.levels.size(), second.levels.size());
    for (std::size_t i = 0; i < first.levels.size(); ++i) EXPECT_EQ(first.levels[i].strips, second.levels[i].strips);
    // The same flips, whatever their order.
    ASSERT_EQ(again.records.first, baked.records.first);
    for (std::size_t i = 0; i < baked.records.size(); ++i) {
      const auto sorted = [](std::span<const StripMesh::Halfedge> flips) {
        std::vector<std::uint32_t> ids;
        for (const auto h : flips) ids.push_back(h.id);
        std::sort(ids.begin(), ids.end());
        return ids;
      };
      ASSERT_EQ(sorted(again.records[i]), sorted(baked.records[i]));
    }
  }
}

// Edges of three triangles and more are joined in pairs, the same ones after the vertices are renumbered.
TEST(BakedFile, NonManifoldMeshesAreRead) {
  std::mt19937 random(5);
  for (int round = 0; round < 300; ++round) {
    Soup soup;
    const std::size_t vertices = 4 + random() % 9;
    const auto coordinate = [&] { return static_cast<double>(random() % 1000); };
    while (soup.points.size() < vertices) soup.points.push_back({coordinate(), coordinate(), coordinate()});
    soup.triangles.resize(2 + random() % 20);
    for (Corners& corners : soup.triangles) do
        for (Vertex& v : corners) v = static_cast<Vertex>(random() % vertices);
      while (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0]);
    const BakedMesh baked = small(soup, 0.5);
    const std::string bytes = baked_bytes(baked);
    ASSERT_EQ(refusal(bytes), "") << round;
    const BakedMesh again = parse_baked(bytes, "some.baked");
    for (Triangle t = 0; t < baked.base.triangle_bound(); ++t)
      ASSERT_EQ(again.base.solid_sides(t), baked.base.solid_sides(t)) << round;
  }
}

TEST(BakedFile, FlipsFarAwayAreKept) {
  BakedMesh baked = small(make_mesh(3000), 0.5);
  // Two edges of the last record's level, exchanged far from its chord.
  StripMesh mesh = baked.base;
  for (std::size_t i = 0; i < baked.records.size(); ++i)
    split_baked(mesh, spokes_of(mesh, baked.mesh.splits[i]), baked.records[i], baked.mesh.splits[i].v_t);
  DualOrder order;
  order.start(mesh, mesh.spoke(baked.mesh.splits.back().v_s, baked.mesh.splits.back().v_t));
  std::size_t n = 3000;
  while (!mesh.solid(order.edge(n))) ++n;
  baked.records.flips.push_back(order.edge(n));
  baked.records.first.back() = static_cast<std::uint32_t>(baked.records.flips.size());
  const BakedMesh again = parse_baked(baked_bytes(baked), "some.baked");
  ASSERT_EQ(again.records.flips.size(), baked.records.flips.size());
  const auto last = again.records[again.records.size() - 1].back();
  EXPECT_EQ(last.id, std::min(order.edge(n).id, mesh.opposite(order.edge(n)).id));
}

// tests/runtime/formats/baked_file_test.cpp cuts and alters every byte.
TEST(BakedFile, RefusalsNameTheFileAndTheFault) {
  const std::string whole = with_payload(baked_bytes(small(make_mesh(200), 0.5)), 2);
  ASSERT_EQ(refusal(whole), "");
  for (const std::size_t size : {std::size_t{0}, std::size_t{12}, whole.size() / 2, whole.size() - 1}) {
    const std::string text = refusal(std::string_view(whole).substr(0, size));
    EXPECT_TRUE(text.starts_with("some.baked: ")) << size;
    EXPECT_NE(text.find("restrip bake"), std::string::npos) << size;
  }
  EXPECT_NE(refusal(whole + '\0').find("checksum"), std::string::npos);
  std::string other_version = whole;
  other_version[8] = 3;
  EXPECT_NE(refusal(with_checksum(other_version)).find("version 3"), std::string::npos);
  EXPECT_NE(refusal("ProgMesh").find("not a baked mesh"), std::string::npos);
}

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
