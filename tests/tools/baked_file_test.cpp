// Claims: what is written is read, mesh, strips and all; nothing truncated, altered or of another version is; and what
// is built to deceive is refused or at least a mesh.
#include "lod/baked_file.hpp"

#include <gtest/gtest.h>

#include <map>
#include <random>

#include "common/bad_input.hpp"
#include "lod/coloring_check.hpp"
#include "lod/pm_file.hpp"
#include "lod/simplify.hpp"
#include "meshes/made_mesh.hpp"
#include "replay/replay.hpp"
#include "restrip/formats/dual_order.hpp"
#include "shapes.hpp"

namespace restrip::tools {
namespace {

BakedMesh small(const Soup& soup, double base) {
  return bake(simplify(soup, {base, BoundaryPolicy::move}).mesh, {20'000});
}

std::string refusal(std::string_view bytes) {
  try {
    (void)parse_baked(bytes, "some.baked");
  } catch (const BadInput& error) {
    return error.what();
  }
  return "";
}

std::string with_checksum(std::string bytes) {
  bytes.resize(bytes.size() - 8);
  const std::uint64_t hash = fnv1a(bytes);
  for (unsigned i = 0; i < 8; ++i) bytes.push_back(static_cast<char>(hash >> (8 * i) & 0xFFU));
  return bytes;
}

TEST(BakedFile, WhatIsWrittenIsRead) {
  for (const Soup& soup : {make_mesh(1500), sheet(18), tetrahedron()}) {
    const BakedMesh baked = small(soup, 0.05);
    const std::string bytes = baked_bytes(baked);
    const BakedMesh again = parse_baked(bytes, "some.baked");
    // The same progressive mesh, with its vertices in order of appearance.
    EXPECT_EQ(pm_bytes(again.mesh), pm_bytes(baked.mesh));
    EXPECT_EQ(baked_bytes(again), bytes);
    ReplayOptions options;
    options.repeats = 0;
    const auto played_from = [](const BakedMesh& played) {
      Plan::Given given;
      given.baked = &played;
      return Plan(way_named("baked"), played.mesh, given);
    };
    const ReplayReport first = replay(played_from(baked), soup.triangles, options);
    const ReplayReport second = replay(played_from(again), {}, options);
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

TEST(BakedFile, EveryTruncationIsRefused) {
  const std::string whole = baked_bytes(small(make_mesh(200), 0.5));
  ASSERT_EQ(refusal(whole), "");
  for (std::size_t size = 0; size < whole.size(); ++size) {
    const std::string text = refusal(std::string_view(whole).substr(0, size));
    ASSERT_TRUE(text.starts_with("some.baked: ")) << size;
    ASSERT_NE(text.find("restrip bake"), std::string::npos) << size;
  }
  EXPECT_NE(refusal(whole + '\0').find("checksum"), std::string::npos);
}

TEST(BakedFile, EveryAlterationIsRefused) {
  const std::string whole = baked_bytes(small(make_mesh(200), 0.5));
  for (std::size_t i = 0; i < whole.size(); ++i)
    for (const unsigned change : {1U, 0x80U, 0xFFU}) {
      std::string altered = whole;
      altered[i] = static_cast<char>(static_cast<unsigned char>(altered[i]) ^ change);
      ASSERT_NE(refusal(altered), "") << i;
    }
  std::string other_version = whole;
  other_version[8] = 2;
  EXPECT_NE(refusal(with_checksum(other_version)).find("version 2"), std::string::npos);
  EXPECT_NE(refusal("ProgMesh").find("no baked mesh"), std::string::npos);
}

TEST(BakedFile, ADeceiverIsRefusedOrAtLeastAMesh) {
  const std::string whole = baked_bytes(small(sheet(7), 0.3));
  std::mt19937 random(1);
  std::map<std::string, std::size_t> said;
  for (int n = 0; n < 4000; ++n) {
    std::string altered = whole;
    const std::size_t at = 12 + random() % (whole.size() - 20);
    altered[at] = static_cast<char>(random());
    altered = with_checksum(altered);
    const std::string text = refusal(altered);
    ++said[text];
    if (!text.empty()) continue;
    const BakedMesh baked = parse_baked(altered, "some.baked");
    EXPECT_TRUE(find_faults(baked.base).empty());
  }
  EXPECT_GT(said[""], 0U);      // a point moved
  EXPECT_GT(said.size(), 10U);  // and many ways to be wrong
}

TEST(DualOrder, NumbersEveryDualEdgeOnce) {
  for (const Soup& soup : {make_mesh(500), sheet(9), tetrahedron()}) {
    const StripMesh mesh = StripMesh::build(soup.triangles, soup.points.size());
    std::size_t edges = 0;
    for (Triangle t = 0; t < mesh.triangle_bound(); ++t)
      for (unsigned side = 0; side < 3; ++side)
        if (!StripMesh::on_boundary(mesh.opposite(StripMesh::halfedge(t, side)))) ++edges;
    edges /= 2;
    DualOrder order;
    for (const Triangle from : {Triangle{0}, static_cast<Triangle>(mesh.triangle_bound() - 1)}) {
      order.start(mesh, StripMesh::halfedge(from, 1));
      std::vector<std::uint32_t> met;
      for (std::size_t n = 0; order.edge(n).id != none; ++n)
        met.push_back(std::min(order.edge(n).id, mesh.opposite(order.edge(n)).id));
      EXPECT_EQ(met.size(), edges);
      std::sort(met.begin(), met.end());
      EXPECT_EQ(std::unique(met.begin(), met.end()), met.end());
    }
  }
}

}  // namespace
}  // namespace restrip::tools
