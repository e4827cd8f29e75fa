// The promises of the headers about whole meshes hold for any number of triangles at one vertex and any length of
// strips: building, strips from scratch for both costs, annealing, and the order for a vertex cache take linear time.
//
// Steps are counted (step_counter.hpp) at two sizes, one twice the other.
#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <string>

#include "hub_meshes.hpp"
#include "output/strip_buffer.hpp"
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

/// measure(mesh) grows as the number of triangles at the hub does.
template <class Measure>
void expect_linear(std::uint32_t n, Measure&& measure) {
  for (std::size_t kind = 0; kind < sample::hub_meshes(1).size(); ++kind) {
    const sample::HubMesh once = sample::hub_meshes(n)[kind];
    const sample::HubMesh twice = sample::hub_meshes(2 * n)[kind];
    SCOPED_TRACE(once.name);
    EXPECT_TRUE(grows_at_most(linear, measure(once), measure(twice)));
  }
}
/// What run(mesh) takes, after prepare(mesh).
template <class Prepare, class Run>
void expect_linear(std::uint32_t n, Prepare&& prepare, Run&& run) {
  expect_linear(n, [&](const sample::HubMesh& hub) {
    StripMesh mesh = StripMesh::build(hub.triangles, hub.vertices);
    EXPECT_EQ(mesh.triangle_count(), hub.triangles.size());
    prepare(mesh);
    const Work work = work_of([&] { run(mesh); });
    EXPECT_TRUE(check_coloring(mesh).valid);
    return work;
  });
}
constexpr auto nothing = [](StripMesh&) {};
constexpr auto fast = [](StripMesh& mesh) { stripify(mesh, Effort::fast, Cost::strips()); };

TEST(HubSteps, BuildingIsLinear) {
  expect_linear(4'000, [](const sample::HubMesh& hub) {
    BuildReport report;
    const Work work = work_of([&] { (void)StripMesh::build(hub.triangles, hub.vertices, &report); });
    EXPECT_EQ(report.non_manifold_vertices, std::string(hub.name) == "pinched" ? 1U : 0U);
    EXPECT_EQ(report.non_manifold_edges + report.inconsistent_edges, 0U);
    return work;
  });
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
  const auto order = [](StripMesh& mesh) { (void)strips_for_vertex_cache(mesh, {.size = 16}); };
  expect_linear(2'000, fast, order);
  expect_linear(2'000, nothing, order);  // each triangle is a strip, all at one vertex
  const auto order_runs = [](StripMesh& mesh) { (void)StripBuffer(mesh); };
  expect_linear(2'000, fast, order_runs);
  expect_linear(2'000, nothing, order_runs);
}

}  // namespace
}  // namespace restrip
