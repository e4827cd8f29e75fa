// Simplifying, replaying and drawing take linear time, baking less than quadratic, however many triangles share one
// vertex. Steps are counted at two sizes, one twice the other. tests/runtime/steps_test.cpp does the same for the
// library.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "common/json.hpp"
#include "lod/bake.hpp"
#include "lod/simplify.hpp"
#include "meshes/little_endian.hpp"
#include "meshes/mend.hpp"
#include "meshes/mesh_file.hpp"
#include "pictures/scene.hpp"
#include "replay/methods.hpp"
#include "replay/replay.hpp"
#include "restrip/output/strips.hpp"
#include "restrip/search/stripify.hpp"
#include "runtime/sample_meshes.hpp"
#include "runtime/step_counter.hpp"
#include "shapes.hpp"

namespace restrip::tools {
namespace {

using counter::grows_at_most;
using counter::linear;
using counter::Work;
using counter::work_of;

/// Binary STL. The corners that collide have one std::hash of their 12 bytes (MurmurHash64A, as libstdc++ has it).
std::string stl_of(std::size_t facets, bool collide) {
  constexpr std::uint64_t factor = 0xC6A4A7935BD1E995;
  constexpr std::uint64_t inverse = 0x5F7A0EA7E59B19BD;
  static_assert(factor * inverse == 1);
  const auto unmixed = [](std::uint64_t k) {
    k *= inverse;
    return (k ^ k >> 47U) * inverse;
  };
  std::string bytes(80, ' ');
  put(bytes, static_cast<std::uint32_t>(facets));
  std::uint32_t last = 0x3F800000;
  for (std::size_t f = 0; f < facets; ++f) {
    bytes += std::string(12, '\0');
    for (unsigned corner = 0; corner < 3;) {
      ++last;
      const std::uint64_t first = collide
                                      ? unmixed(((0x123456789ABCDEF0 ^ last) * inverse) ^ 0xC70F6907 ^ (12 * factor))
                                      : (std::uint64_t{last} << 32U | last * 7919U);
      const auto x = static_cast<std::uint32_t>(first);
      const auto y = static_cast<std::uint32_t>(first >> 32U);
      if (!std::isfinite(std::bit_cast<float>(x)) || !std::isfinite(std::bit_cast<float>(y))) continue;
      put(bytes, x), put(bytes, y), put(bytes, last);
      ++corner;
    }
    bytes += std::string(2, '\0');
  }
  return bytes;
}

TEST(Reading, PlacesThatCollideTakeTheSameNumberOfSteps) {
  const auto steps = [](bool collide) {
    const std::string bytes = stl_of(3000, collide);
    Soup soup;
    const Work work = work_of([&] {
      soup = read_as(".stl", bytes);
      EXPECT_EQ(coincident_vertices(soup), 0U);
      Mended mended;
      weld(soup, mended);
    });
    EXPECT_EQ(soup.points.size(), 9000U);
    return work.steps;
  };
  EXPECT_LT(steps(true), 2 * steps(false));
}

TEST(Reading, MembersOfAnObjectAreFoundWithoutWalkingOverIt) {
  const auto work = [](std::size_t members) {
    std::string text = "{";
    for (std::size_t i = 0; i < members; ++i) text += fmt::format("\"x{}\":{},", i, i);
    text.back() = '}';
    return work_of([&] {
      const JsonValue tree = parse_json("f", text, {.strict = false});
      for (std::size_t i = 0; i < members; ++i) EXPECT_EQ(tree[fmt::format("x{}", i)].whole(), i);
    });
  };
  EXPECT_TRUE(grows_at_most(linear, work(1000), work(2000)));
}

/// On rings of n around vertex 0, each turned by half a step, so that most edges can collapse at either size.
Soup soup_of(const sample::HubMesh& mesh, std::uint32_t n) {
  Soup soup;
  soup.triangles = mesh.triangles;
  soup.points.push_back({});
  for (std::uint32_t v = 0; v + 1 < mesh.vertices; ++v) {
    const double step = 6.283185307179586 / n;
    const double turn = step * (v + 0.5 * (v / n));
    const double radius = 1 / step + v / n;
    soup.points.push_back({static_cast<float>(radius * std::cos(turn)), static_cast<float>(radius * std::sin(turn)),
                           static_cast<float>(v % 7) / 8});
  }
  return soup;
}

struct Simplified {
  Soup soup;
  ProgressiveMesh mesh;  ///< from a tenth of the triangles
};

/// The meshes with a hub of n triangles, made once.
const std::vector<Simplified>& simplified(std::uint32_t n) {
  static std::map<std::uint32_t, std::vector<Simplified>> made;
  const auto [place, fresh] = made.try_emplace(n);
  if (fresh)
    for (const sample::HubMesh& mesh : sample::hub_meshes(n)) {
      const Soup soup = soup_of(mesh, n);
      place->second.push_back({soup, simplify(soup, {0.1, BoundaryPolicy::move}).mesh});
    }
  return place->second;
}

/// The steps of run(soup, mesh) on each mesh with a hub of n and of 2 n triangles; `mesh` is simplified to a tenth.
template <class Run>
void expect_linear(std::uint32_t n, Run&& run, double most = linear) {
  constexpr std::size_t kinds = 3;
  std::array<std::array<Work, 2>, kinds> work;
  for (const unsigned size : {0U, 1U}) {
    const auto& meshes = simplified(n << size);
    ASSERT_EQ(meshes.size(), kinds);
    for (std::size_t kind = 0; kind < kinds; ++kind) {
      ASSERT_EQ(meshes[kind].mesh.splits.empty(), kind == 0) << "no triangle of the pinched mesh has a neighbour";
      work[kind][size] = work_of([&] { run(meshes[kind].soup, meshes[kind].mesh); });
    }
  }
  for (std::size_t kind = 0; kind < kinds; ++kind) {
    SCOPED_TRACE(sample::hub_meshes(1)[kind].name);
    EXPECT_TRUE(grows_at_most(most, work[kind][0], work[kind][1]));
  }
}

TEST(ToolsHubSteps, SimplifyingIsLinear) {
  expect_linear(3'000, [](const Soup& soup, const ProgressiveMesh&) {
    EXPECT_GT(simplify(soup, {0.1, BoundaryPolicy::move}).wanted_triangles, 0U);
  });
}

// Open fans, two fans with walls between them, and a flat fan, whose collapses all cost the same.
TEST(ToolsHubSteps, SimplifyingAndReplayingFansOfEveryKindIsLinear) {
  const auto flat = [](std::uint32_t n) { return disc(n, 3); };
  for (Soup (*const make)(std::uint32_t) : {open_cone, cylinder, +flat}) {
    std::array<Work, 2> simplifying;
    std::array<Work, 2> replaying;
    for (const unsigned size : {0U, 1U}) {
      const Soup soup = make(2'000U << size);
      Simplification result;
      simplifying[size] = work_of([&] { result = simplify(soup, {0.02, BoundaryPolicy::move}); });
      EXPECT_FALSE(result.stopped_short());
      const PreparedMethod prepared("local", result.mesh);
      replaying[size] = work_of([&] { EXPECT_TRUE(replay(prepared, soup.triangles, {2, 0, 1}).valid()); });
    }
    EXPECT_TRUE(grows_at_most(linear, simplifying[0], simplifying[1]));
    EXPECT_TRUE(grows_at_most(linear, replaying[0], replaying[1]));
  }
}

// Nothing may collapse at the faults, and every remaining edge is examined.
TEST(ToolsHubSteps, StoppingShortIsLinear) {
  expect_linear(3'000, [](const Soup& soup, const ProgressiveMesh&) {
    EXPECT_TRUE(simplify(soup, {0.5, BoundaryPolicy::lock, 1}).stopped_short());
  });
}

// The search for few strips at coarse levels takes more steps than linear on rings; it stays below quadratic time.
TEST(ToolsHubSteps, BakingIsBelowQuadraticTime) {
  for (const Cost cost : {Cost::strips(), Cost::indices()})
    expect_linear(
        1'500,
        [cost](const Soup&, const ProgressiveMesh& mesh) {
          EXPECT_EQ(bake(mesh, {2'000, cost}).records.size(), mesh.splits.size());
        },
        3.4);
}

TEST(ToolsHubSteps, DrawingIsLinear) {
  expect_linear(3'000, [](const Soup& soup, const ProgressiveMesh&) {
    const StripMesh mesh = stripified(soup);
    const Strips order = extract_strips(mesh);
    std::vector<StripCorners> strips(order.size());
    for (std::size_t s = 0; s < order.size(); ++s)
      for (const Triangle t : order[s]) strips[s].push_back(mesh.corners(t));
    const Scene scene = scene_of(soup.points, strips, {}, {64, 64});
    EXPECT_FALSE(svg_of(scene).bytes.empty());
    EXPECT_FALSE(png_of(scene).bytes.empty());
  });
}

// A picture of any number of strips has a colour for each, computed from its number.
TEST(ToolsHubSteps, ColoringStripsIsLinear) {
  std::array<Work, 2> work;
  for (const unsigned size : {0U, 1U}) {
    const Soup soup = soup_of(sample::pinched(100'000U << size), 100'000U << size);
    std::vector<StripCorners> strips;
    for (const Corners& t : soup.triangles) strips.push_back({t});
    std::size_t colors = 0;
    work[size] = work_of([&] { colors = scene_of(soup.points, strips, {}, {64, 64}).colors.size(); });
    EXPECT_EQ(colors, strips.size());
  }
  EXPECT_TRUE(grows_at_most(linear, work[0], work[1]));
}

}  // namespace
}  // namespace restrip::tools
