// Baked flips produce exactly the colouring they were taken from, and undo it; a sequence played up and down is the
// same bit for bit.
#include "restrip/operations/baked.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "../../support/random_operations.hpp"
#include "restrip/mesh/checks.hpp"
#include "restrip/output/strips.hpp"
#include "restrip/search/keeper.hpp"
#include "restrip/search/stripify.hpp"
#include "sample_meshes.hpp"

namespace restrip {
namespace {

using Halfedge = StripMesh::Halfedge;
using Where = VertexSplit;
using Spokes = Where::Spokes;
using sample::colors_of;

std::size_t valid_strips(const StripMesh& mesh) {
  const ColoringReport report = check_coloring(mesh);
  EXPECT_TRUE(report.valid);
  return report.strips;
}

Where random_place(const StripMesh& mesh, std::mt19937& random) {
  Where where = random_split(mesh, random_halfedge(mesh, random), random);
  if (where.spokes == Spokes::both && random() % 2 == 0) std::swap(where.left, where.right);
  return where;
}

struct Sequence {
  struct Step {
    Vertex v_s, v_t, v_l, v_r;
  };
  StripMesh base;
  std::vector<Step> steps;
  BakedRecords records;
  std::vector<std::vector<std::uint8_t>> levels;

  [[nodiscard]] static Where where(const StripMesh& mesh, const Step& step) {
    const Halfedge left = step.v_l == none ? Halfedge{} : mesh.spoke(step.v_s, step.v_l);
    const Halfedge right = step.v_r == none ? Halfedge{} : mesh.spoke(step.v_s, step.v_r);
    return {left, right, step.v_l == none ? Spokes::right_only : step.v_r == none ? Spokes::left_only : Spokes::both};
  }
};

Sequence sequence_on(StripMesh mesh, unsigned seed, int tries) {
  stripify(mesh, Effort::fast, Cost::strips());
  Sequence sequence{mesh, {}, {}, {colors_of(mesh)}};
  std::mt19937 random(seed);
  for (int n = 0; n < tries; ++n) {
    const Where where = random_place(mesh, random);
    if (check_split(mesh, where) != Refusal::granted) continue;
    const bool left = where.spokes != Spokes::right_only;
    const bool right = where.spokes != Spokes::left_only;
    const Halfedge first = left ? where.left : where.right;
    const auto v_t = static_cast<Vertex>(mesh.vertex_bound());
    sequence.steps.push_back(
        {mesh.from(first), v_t, left ? mesh.to(where.left) : none, right ? mesh.to(where.right) : none});
    StripMesh plain = mesh;
    split_baked(plain, where, {}, v_t);
    Keeper(mesh, Policy::local, Cost::strips()).split(where, v_t);
    for (const Halfedge h : sample::recolored_edges(plain, mesh)) sequence.records.flips.push_back(h);
    sequence.records.first.push_back(static_cast<std::uint32_t>(sequence.records.flips.size()));
    sequence.levels.push_back(colors_of(mesh));
  }
  return sequence;
}

TEST(Baked, RoundTripsAreTheSameBitForBit) {
  for (const StripMesh& start : {sample::sphere(2), sample::rectangle(6, 5), sample::torus(9, 7)}) {
    const Sequence sequence = sequence_on(start, 11, 300);
    StripMesh mesh = sequence.base;
    std::size_t at = 0;
    const auto expect_level = [&](std::size_t level) {
      std::vector<std::uint8_t> now = colors_of(mesh);
      now.resize(sequence.levels[level].size());
      ASSERT_EQ(now, sequence.levels[level]);
    };
    std::mt19937 random(5);
    const std::size_t n = sequence.steps.size();
    ASSERT_GT(n, 100U);
    // All the way up, then to levels drawn at random.
    std::size_t goal = n;
    for (int trip = 0; trip < 40; ++trip, goal = random() % (n + 1)) {
      while (at < goal) {
        const auto& step = sequence.steps[at];
        split_baked(mesh, Sequence::where(mesh, step), sequence.records[at++], step.v_t);
        if (trip < 2) expect_level(at);
      }
      while (at > goal) {
        const auto& step = sequence.steps[--at];
        collapse_baked(mesh, mesh.spoke(step.v_s, step.v_t), sequence.records[at]);
        if (trip < 2) expect_level(at);
      }
      expect_level(goal);
      valid_strips(mesh);
    }
  }
}

}  // namespace
}  // namespace restrip
