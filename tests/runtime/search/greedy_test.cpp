// Strips from scratch in one pass are valid, the same every time, and few.
#include "restrip/search/impl/greedy.hpp"

#include <gtest/gtest.h>

#include "restrip/output/strips.hpp"
#include "sample_meshes.hpp"

namespace restrip {
namespace {

TEST(StripifyFast, IsValidAndCounts) {
  for (StripMesh& mesh : sample::meshes()) {
    const std::size_t strips = stripify_fast(mesh);
    const ColoringReport report = check_coloring(mesh);
    EXPECT_TRUE(report.valid);
    EXPECT_EQ(report.strips, strips);
  }
}

TEST(StripifyFast, ForgetsEarlierColors) {
  StripMesh mesh = sample::torus(30, 20);
  const std::size_t strips = stripify_fast(mesh);
  const Strips first = extract_strips(mesh);
  EXPECT_EQ(stripify_fast(mesh), strips);
  EXPECT_EQ(extract_strips(mesh).order, first.order);
}

TEST(StripifyFast, LeavesFewStrips) {
  StripMesh sphere = sample::sphere(6);  // 32,768 triangles
  EXPECT_LE(stripify_fast(sphere), 32768U / 200);
  StripMesh torus = sample::torus(120, 100);  // 24,000 triangles, irregular
  EXPECT_LE(stripify_fast(torus), 24000U / 100);
}

}  // namespace
}  // namespace restrip
