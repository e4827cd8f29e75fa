// The promises of the headers about whole meshes hold for any number of triangles at one vertex and any length of
// strips: building, strips from scratch for both costs, annealing, and the order for a vertex cache take linear time.
//
// Steps are counted (step_counter.hpp) at two sizes, one twice the other.
#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>

#include "hub_meshes.hpp"
#include "restrip/output/strip_order.hpp"
#include "restrip/output/strips.hpp"
#include "restrip/search/stripify.hpp"
#include "step_counter.hpp"

namespace restrip {
namespace {

using counter::grows_at_most;
using counter::linear;
using counter::Work;
using counter::work_of;

constexpr std::size_t kinds = 3;

/// What run(mesh) takes on each of the meshes with a hub of n and of 2 n triangles, after prepare(mesh).
template <class Prepare, class Run>
void expect_linear(std::uint32_t n, Prepare&& prepare, Run&& run) {
  std::array<std::array<Work, 2>, kinds> work;
  for (const unsigned size : {0U, 1U}) {
    const auto meshes = sample::hub_meshes(n << size);
    ASSERT_EQ(meshes.size(), kinds);
    for (std::size_t kind = 0; kind < kinds; ++kind) {
      StripMesh mesh = StripMesh::build(meshes[kind].triangles, meshes[kind].vertices);
      ASSERT_EQ(mesh.triangle_count(), meshes[kind].triangles.size());
      prepare(mesh);
      work[kind][size] = work_of([&] { run(mesh); });
      ASSERT_TRUE(check_coloring(mesh).valid);
    }
  }
  for (std::size_t kind = 0; kind < kinds; ++kind) {
    SCOPED_TRACE(sample::hub_meshes(1)[kind].name);
    EXPECT_TRUE(grows_at_most(linear, work[kind][0], work[kind][1]));
  }
}
constexpr auto nothing = [](StripMesh&) {};
constexpr auto fast = [](StripMesh& mesh) { stripify(mesh, Effort::fast, Cost::strips()); };

TEST(HubSteps, BuildingIsLinear) {
  std::array<std::array<Work, 2>, kinds> work;
  for (const unsigned size : {0U, 1U}) {
    const auto meshes = sample::hub_meshes(4'000U << size);
    for (std::size_t kind = 0; kind < kinds; ++kind) {
      BuildReport report;
      work[kind][size] =
          work_of([&] { (void)StripMesh::build(meshes[kind].triangles, meshes[kind].vertices, &report); });
      EXPECT_EQ(report.non_manifold_vertices, kind == 0 ? 1U : 0U);
      EXPECT_EQ(report.non_manifold_edges + report.inconsistent_edges, 0U);
    }
  }
  for (std::size_t kind = 0; kind < kinds; ++kind) {
    SCOPED_TRACE(sample::hub_meshes(1)[kind].name);
    EXPECT_TRUE(grows_at_most(linear, work[kind][0], work[kind][1]));
  }
}

TEST(HubSteps, StripsFromScratchAreLinear) {
  expect_linear(4'000, nothing, fast);
  expect_linear(4'000, nothing, [](StripMesh& mesh) { stripify(mesh, Effort::fast, Cost::indices()); });
}

TEST(HubSteps, SearchesFromScratchAreLinear) {
  expect_linear(2'000, nothing,
                [](StripMesh& mesh) { stripify(mesh, Effort::full, Cost::strips(), 2 * mesh.triangle_count()); });
}

// Walks along strips end at some length, and triangles without a flaw are not examined one by one.
TEST(HubSteps, AnnealingIsLinear) {
  expect_linear(2'000, nothing,
                [](StripMesh& mesh) { stripify(mesh, Effort::full, Cost::indices(), 20 * mesh.triangle_count()); });
}

TEST(HubSteps, OrderForTheCacheIsLinear) {
  const auto order = [](StripMesh& mesh) { (void)order_for_vertex_cache(mesh, extract_strips(mesh)); };
  expect_linear(2'000, fast, order);
  expect_linear(2'000, nothing, order);  // each triangle is a strip, all at one vertex
}

}  // namespace
}  // namespace restrip
