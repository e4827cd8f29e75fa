// Strips from scratch are valid, the same every time, and the fewest possible; and no change of the searches
// alters strips made for the cost of strips.
#include "restrip/search/stripify.hpp"

#include <gtest/gtest.h>

#include <cstdint>

#include "restrip/mesh/walks.hpp"
#include "restrip/output/strips.hpp"
#include "sample_meshes.hpp"

namespace restrip {
namespace {

TEST(StripifyFull, ReachesOneStripOnClosedMeshes) {
  StripMesh sphere = sample::sphere(4);
  EXPECT_EQ(stripify(sphere, Effort::full, Cost::strips()), 1U);
  EXPECT_EQ(check_coloring(sphere).strips, 1U);
  StripMesh torus = sample::torus(60, 50);
  EXPECT_EQ(stripify(torus, Effort::full, Cost::strips()), 1U);
  EXPECT_TRUE(check_coloring(torus).valid);
}

// Deterministic: the earlier colours do not matter, the seed does.
TEST(StripifyFull, EveryEffortIsValidCountedAndTheSameEveryTime) {
  for (const Cost& cost : {Cost::strips(), Cost::indices()})
    for (const Effort effort : {Effort::fast, Effort::full, Effort::best}) {
      for (StripMesh& mesh : sample::meshes()) {
        const std::size_t strips = stripify(mesh, effort, cost, 5000);
        const ColoringReport report = check_coloring(mesh);
        EXPECT_TRUE(report.valid);
        EXPECT_EQ(report.strips, strips);
        EXPECT_GE(strips, connected_components(mesh));
        const Strips first = extract_strips(mesh);
        EXPECT_EQ(stripify(mesh, effort, cost, 5000), strips);
        EXPECT_EQ(extract_strips(mesh).order, first.order);
      }
      StripMesh empty;
      EXPECT_EQ(stripify(empty, effort, cost), 0U);
    }
  const auto order = [](std::uint64_t seed) {
    StripMesh mesh = sample::torus(30, 20);
    stripify(mesh, Effort::full, Cost::indices(), 0, seed);
    return extract_strips(mesh).order;
  };
  EXPECT_NE(order(1), order(2));
}

TEST(StripifyFast, LeavesFewStrips) {
  StripMesh sphere = sample::sphere(6);  // 32,768 triangles
  EXPECT_LE(stripify(sphere, Effort::fast, Cost::strips()), 32768U / 200);
  StripMesh torus = sample::torus(120, 100);  // 24,000 triangles, irregular
  EXPECT_LE(stripify(torus, Effort::fast, Cost::strips()), 24000U / 100);
}

// A digest of the colours that no change of the searches may alter while strips alone have a weight.
std::uint64_t digest(const StripMesh& mesh) {
  std::uint64_t sum = 14'695'981'039'346'656'037U;  // FNV-1a
  for (Triangle t = 0; t < mesh.triangle_bound(); ++t) sum = (sum ^ mesh.solid_sides(t)) * 1'099'511'628'211U;
  return sum;
}

TEST(Stripify, FewestStripsAreWhatTheyWere) {
  StripMesh mesh = sample::torus(60, 50);
  stripify(mesh, Effort::fast, Cost::strips());
  EXPECT_EQ(digest(mesh), 3739437743101561692U);
  stripify(mesh, Effort::fast, Cost::strips());
  EXPECT_EQ(digest(mesh), 3739437743101561692U);
  stripify(mesh, Effort::full, Cost::strips());
  EXPECT_EQ(digest(mesh), 3166561605149442275U);
  stripify(mesh, Effort::full, Cost::strips());
  EXPECT_EQ(digest(mesh), 3166561605149442275U);
}

}  // namespace
}  // namespace restrip
