// Baked flips lead from level to level and back: a sequence played up and down is the same bit for bit, and has the
// colours of the strips from which it was taken.
#include "restrip/operations/baked.hpp"

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "baked_sequence.hpp"
#include "restrip/output/strips.hpp"
#include "sample_meshes.hpp"

namespace restrip {
namespace {

TEST(Baked, RoundTripsAreTheSameBitForBit) {
  for (const StripMesh& start : {sample::sphere(2), sample::rectangle(9, 8), sample::torus(9, 7)}) {
    std::vector<std::vector<std::uint8_t>> levels;
    const auto file = baked_sequence(start, &levels);
    StripMesh mesh = file->mesh;
    std::size_t at = 0;
    const auto expect_level = [&] {
      std::vector<std::uint8_t> now = sample::colors_of(mesh);
      now.resize(levels[at].size());
      ASSERT_EQ(now, levels[at]);
    };
    std::mt19937 random(5);
    const std::size_t n = file->splits.size();
    ASSERT_GT(n, 20U);
    // All the way up, then to levels drawn at random.
    std::size_t goal = n;
    for (int trip = 0; trip < 40; ++trip, goal = random() % (n + 1)) {
      while (at < goal) {
        const SplitRecord& split = file->splits[at];
        split_baked(mesh, spokes_of(mesh, split), file->records[at++], split.v_t);
        if (trip < 2) expect_level();
      }
      while (at > goal) {
        const SplitRecord& split = file->splits[--at];
        collapse_baked(mesh, mesh.spoke(split.v_s, split.v_t), file->records[at]);
        if (trip < 2) expect_level();
      }
      expect_level();
      EXPECT_TRUE(check_coloring(mesh).valid);
    }
    EXPECT_EQ(
        sample::triangles_of(file->mesh).size() +
            [&] {
              std::size_t more = 0;
              for (const SplitRecord& split : file->splits) more += split.triangles();
              return more;
            }(),
        start.triangle_count());
  }
}

}  // namespace
}  // namespace restrip
