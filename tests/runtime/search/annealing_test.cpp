// Strips from scratch under a cost: valid, not more expensive with more effort, and on meshes small enough to try every
// colouring the cheapest possible but for one wrong winding, which moves do not price. Costs are counted here from the
// strips and the index buffer, not from the sums of the search.
#include "search/annealing.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

#include "measure/index_bound.hpp"
#include "restrip/output/strips.hpp"
#include "restrip/search/stripify.hpp"
#include "sample_meshes.hpp"

namespace restrip {
namespace {

using sample::dual_edges;

constexpr std::array<Cost, 5> annealed_costs{Cost::indices(), {3, 1, 2}, {1, 0, 1}, {100, 70, 1}, {0, 1, 0}};

// In the written strips a swap is an index that is written more than once.
std::uint64_t recounted(const StripMesh& mesh, Cost cost) {
  const Strips strips = extract_strips(mesh);
  const std::size_t indices = strip_indices(mesh, strips).size();
  const std::size_t swaps = indices + 1 - mesh.triangle_count() - 3 * strips.size();
  std::uint64_t isolated = 0;
  for (std::size_t s = 0; s < strips.size(); ++s) isolated += strips[s].size() == 1 ? 1U : 0U;
  return std::uint64_t{cost.restart} * strips.size() + std::uint64_t{cost.swap} * swaps + cost.isolated * isolated;
}

TEST(Anneal, BestIsTheLeastOfAllColoringsOfTinyMeshesButForAWinding) {
  for (StripMesh& mesh : sample::tiny_meshes()) {
    const std::vector<StripMesh::Halfedge> edges = dual_edges(mesh);
    ASSERT_LE(edges.size(), 15U);
    std::array<std::uint64_t, annealed_costs.size()> least{};
    least.fill(std::numeric_limits<std::uint64_t>::max());
    std::size_t fewest_indices = std::numeric_limits<std::size_t>::max();
    for (std::uint32_t colors = 0; colors < 1U << edges.size(); ++colors) {
      for (std::size_t e = 0; e < edges.size(); ++e) mesh.set_solid(edges[e], (colors >> e & 1U) != 0);
      if (!check_coloring(mesh).valid) continue;
      for (std::size_t i = 0; i < annealed_costs.size(); ++i)
        least[i] = std::min(least[i], recounted(mesh, annealed_costs[i]));
      fewest_indices = std::min(fewest_indices, strip_index_count(mesh, extract_strips(mesh)));
    }
    for (std::size_t i = 0; i < annealed_costs.size(); ++i) {
      stripify(mesh, Effort::best, annealed_costs[i]);
      // A wrong winding weighs more than a move gains only where a swap weighs most of a strip.
      const std::uint64_t winding = annealed_costs[i].swap > 1 ? annealed_costs[i].swap : 0;
      EXPECT_LE(recounted(mesh, annealed_costs[i]), least[i] + winding)
          << "cost " << i << ", " << edges.size() << " dual edges";
    }
    EXPECT_LE(tools::strip_index_lower_bound(mesh), fewest_indices);
  }
}

TEST(Anneal, MoreEffortCostsNoMore) {
  for (StripMesh& mesh : sample::meshes())
    for (const Cost cost : annealed_costs) {
      std::uint64_t before = std::numeric_limits<std::uint64_t>::max();
      for (const Effort effort : {Effort::fast, Effort::full, Effort::best}) {
        const std::size_t strips = stripify(mesh, effort, cost);
        const ColoringReport report = check_coloring(mesh);
        EXPECT_TRUE(report.valid);
        EXPECT_EQ(report.strips, strips);
        EXPECT_LE(recounted(mesh, cost), before);
        before = recounted(mesh, cost);
      }
    }
}

/// Anneals from the present colours; the mesh keeps the cheapest, whose cost is returned.
std::uint64_t anneal(StripMesh& mesh, Cost cost, std::uint64_t moves, std::uint64_t seed, std::uint32_t heat) {
  detail::Annealing annealing(detail::ColoringCopy(mesh), cost, seed);
  annealing.keep();
  annealing.cool(moves, heat);
  annealing.keep();
  annealing.go_back();
  annealing.give(mesh);
  return annealing.least();
}

TEST(Anneal, ReportsTheCostOfValidColorsAndNeverRaisesIt) {
  std::mt19937 random(4);
  for (StripMesh& mesh : sample::meshes())
    for (const Cost cost : annealed_costs)
      for (const std::uint64_t moves : {1U, 10U, 300U, 5000U}) {
        sample::color_at_random(mesh, 0.7, random);
        const std::uint64_t before = recounted(mesh, cost);
        const std::uint64_t reported = anneal(mesh, cost, moves, random(), moves == 300U ? 0 : 100);
        EXPECT_TRUE(check_coloring(mesh).valid);
        EXPECT_EQ(reported, recounted(mesh, cost));
        EXPECT_LE(reported, before);
      }
}

TEST(Anneal, IndicesAreFewOnLargerMeshes) {
  for (StripMesh& mesh : std::array{sample::torus(60, 50), sample::rectangle(50, 40)}) {
    const auto indices = [&mesh](Effort effort, Cost cost) {
      stripify(mesh, effort, cost);
      return strip_indices(mesh).size();
    };
    const std::size_t with_fewest_strips = indices(Effort::fast, Cost::strips());
    const std::size_t fast = indices(Effort::fast, Cost::indices());
    const std::size_t full = indices(Effort::full, Cost::indices());
    EXPECT_LT(fast, with_fewest_strips - with_fewest_strips / 20);
    EXPECT_LT(full, fast - fast / 50);
    EXPECT_GT(full, tools::strip_index_lower_bound(mesh));
  }
}

// Of an exchange at the end of a strip. The recount does each on the mesh and counts all of it before and after.
TEST(Anneal, LeastChangeIsWhatTheRecountSays) {
  std::mt19937 random(7);
  std::size_t exact = 0;
  std::size_t all = 0;
  std::vector<StripMesh> meshes = sample::tiny_meshes();
  meshes.push_back(sample::sphere(1));
  meshes.push_back(sample::rectangle(5, 4));
  for (StripMesh& mesh : meshes)
    for (unsigned round = 0; round < 200; ++round) {
      sample::color_at_random(mesh, 0.9, random);
      const Cost cost = annealed_costs[round % annealed_costs.size()];
      const auto counted = [&] {
        const ColoringReport report = check_coloring(mesh);
        return static_cast<std::int64_t>(cost.restart * report.strips + cost.swap * count_swaps(mesh) +
                                         cost.isolated * report.isolated);
      };
      const detail::Annealing annealing(detail::ColoringCopy(mesh), cost, 1);
      for (const StripMesh::Halfedge here : sample::sides_of(mesh)) {
        if (mesh.solid(here) || mesh.solid_degree(StripMesh::triangle(here)) > 1) continue;
        const StripMesh::Halfedge there = mesh.opposite(here);
        if (StripMesh::on_boundary(there) || mesh.solid_degree(StripMesh::triangle(there)) < 2) continue;
        for (const unsigned before : {0U, 1U}) {
          const StripMesh::Halfedge out =
              before != 0 ? StripMesh::next(StripMesh::next(there)) : StripMesh::next(there);
          const std::int64_t reported = annealing.least_change(here.id, before);
          const std::int64_t was = counted();
          mesh.set_solid(out, false);
          mesh.set_solid(here, true);
          const bool valid = check_coloring(mesh).valid;
          const std::int64_t is = counted();
          mesh.set_solid(here, false);
          mesh.set_solid(out, true);
          if (!valid) continue;
          ++all;
          if (reported == std::numeric_limits<std::int64_t>::min()) continue;
          ++exact;
          ASSERT_EQ(reported, is - was);
        }
      }
    }
  EXPECT_GT(exact, 1000U);
  EXPECT_GT(2 * exact, all);
}

}  // namespace
}  // namespace restrip
