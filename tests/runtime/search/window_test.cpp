// A window finds what exhaustive search finds: on patches small enough to try every colouring of the edges inside, with
// and without edges that leave them, it has the least price and reports the change, and with Ties::fewest_changes no
// colouring of that price is nearer to the previous one; with limits it says when it may have missed something. It
// touches no other edge and never raises the price. Prices are counted here along the strips
// and in the index buffer, not by the sums of the search.
#include "restrip/search/impl/window.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <random>
#include <span>
#include <utility>
#include <vector>

#include "coloring_cost.hpp"
#include "restrip/output/strips.hpp"
#include "restrip/search/stripify.hpp"
#include "sample_meshes.hpp"
#include "strip_moves.hpp"

namespace restrip {
namespace {

using moves::dual_edges;
using moves::Halfedge;

constexpr std::array<Cost, 6> window_costs{Cost::indices(), Cost::strips(), {3, 1, 2},
                                           {1, 0, 1},       {100, 70, 1},   {0, 1, 0}};
constexpr WindowLimits exact{.slack = WindowLimits::no_limit, .states = WindowLimits::no_limit};

struct Counted {
  ColoringChange colors;
  int windings = 0;
};

// In the written strips a swap is an index that is written more than once, and so is a wrong winding.
Counted counted(const StripMesh& mesh) {
  const ColoringChange colors = cost_of(mesh);
  const std::size_t indices = strip_indices(mesh).size();
  const auto more = static_cast<int>(indices + 1 - mesh.triangle_count());
  return {colors, more - 3 * colors.strips - colors.swaps};
}

std::int64_t price(const Counted& count, Cost cost, Windings windings) {
  return count.colors.price(cost) + (windings == Windings::priced ? std::int64_t{cost.swap} * count.windings : 0);
}

// The dual edges between triangles of a patch.
std::vector<Halfedge> edges_inside(const StripMesh& mesh, std::span<const Triangle> patch) {
  const auto inside = [&](Triangle t) { return std::find(patch.begin(), patch.end(), t) != patch.end(); };
  std::vector<Halfedge> edges = dual_edges(mesh);
  std::erase_if(edges, [&](Halfedge h) {
    return !inside(StripMesh::triangle(h)) || !inside(StripMesh::triangle(mesh.opposite(h)));
  });
  return edges;
}

// The edges that have other colours in another mesh.
std::size_t differing(std::span<const Halfedge> edges, const StripMesh& a, const StripMesh& b) {
  return static_cast<std::size_t>(
      std::count_if(edges.begin(), edges.end(), [&](Halfedge h) { return a.solid(h) != b.solid(h); }));
}

// A colouring: its price, and how many edges it changes.
using Cheapness = std::pair<std::int64_t, std::size_t>;

// Every colouring of these edges that is valid: the least price for each cost, windings ignored and priced, and the
// fewest edges that a colouring of that price changes.
using Least = std::array<std::array<Cheapness, 2>, window_costs.size()>;
Least least_of_all(const StripMesh& start, std::span<const Halfedge> edges) {
  StripMesh mesh = start;
  Least least;
  for (auto& of_cost : least) of_cost.fill({std::numeric_limits<std::int64_t>::max(), 0});
  const auto degree_of = [&](Triangle t) { return mesh.solid_degree(t); };
  for (std::uint32_t colors = 0; colors < 1U << edges.size(); ++colors) {
    for (std::size_t e = 0; e < edges.size(); ++e) mesh.set_solid(edges[e], (colors >> e & 1U) != 0);
    const bool degrees = std::all_of(edges.begin(), edges.end(), [&](Halfedge h) {
      return degree_of(StripMesh::triangle(h)) <= 2 && degree_of(StripMesh::triangle(mesh.opposite(h))) <= 2;
    });
    if (!degrees || !check_coloring(mesh).valid) continue;
    const Counted count = counted(mesh);
    const std::size_t changes = differing(edges, mesh, start);
    for (std::size_t c = 0; c < window_costs.size(); ++c)
      for (const Windings windings : {Windings::ignored, Windings::priced}) {
        Cheapness& so_far = least[c][static_cast<std::size_t>(windings)];
        so_far = std::min(so_far, {price(count, window_costs[c], windings), changes});
      }
  }
  return least;
}

struct Asked {
  WindowLimits limits;
  Ties ties;
};
constexpr std::array<Asked, 4> ways_to_ask{{{exact, Ties::random},
                                            {exact, Ties::fewest_changes},
                                            {{}, Ties::fewest_changes},
                                            {{.slack = 0, .states = 2}, Ties::random}}};

// Runs windows of each cost on copies of the mesh. Returns how many results were compared.
std::size_t expect_least(const StripMesh& start, std::span<const Triangle> patch, std::uint64_t seed) {
  const std::vector<Halfedge> edges = edges_inside(start, patch);
  EXPECT_LE(edges.size(), 15U);
  const Counted before = counted(start);
  const Least least = least_of_all(start, edges);
  std::size_t compared = 0;
  for (std::size_t c = 0; c < window_costs.size(); ++c)
    for (const Windings windings : {Windings::ignored, Windings::priced})
      for (const Asked& asked : ways_to_ask) {
        StripMesh mesh = start;
        Window window(window_costs[c], seed, windings, asked.ties);
        const WindowChange done = window.inside(mesh, patch, asked.limits);
        EXPECT_TRUE(check_coloring(mesh).valid);
        const Counted after = counted(mesh);
        EXPECT_EQ(done.change, after.colors - before.colors);
        EXPECT_EQ(done.windings, after.windings - before.windings);
        const std::int64_t reached = price(after, window_costs[c], windings);
        const auto [goal, fewest] = least[c][static_cast<std::size_t>(windings)];
        const std::size_t changes = differing(edges, mesh, start);
        if (asked.limits.slack == WindowLimits::no_limit) {
          EXPECT_TRUE(done.proven);
          if (asked.ties == Ties::fewest_changes) {
            EXPECT_EQ(changes, fewest);
          }
        }
        if (asked.ties == Ties::fewest_changes && reached == price(before, window_costs[c], windings)) {
          EXPECT_EQ(changes, 0U);
        }
        EXPECT_GE(reached, goal);
        EXPECT_LE(reached, price(before, window_costs[c], windings));
        if (done.proven) {
          EXPECT_EQ(reached, goal) << "cost " << c;
          ++compared;
        }
        for (const Halfedge h : dual_edges(start)) {
          if (std::find(edges.begin(), edges.end(), h) == edges.end()) {
            EXPECT_EQ(mesh.solid(h), start.solid(h));
          }
        }
      }
  return compared;
}

// Patches of a mesh with few edges inside: balls, as windows take them, and triangles drawn at random.
std::vector<std::vector<Triangle>> small_patches(const StripMesh& mesh, std::mt19937& random) {
  std::vector<std::vector<Triangle>> patches;
  const std::vector<Triangle> all = moves::all_triangles(mesh);
  for (const std::uint32_t size : {1U, 2U, 5U, 8U, 10U}) {
    StripMesh copy = mesh;
    Window window(Cost::indices(), random());
    window.around(copy, all[random() % all.size()], {.triangles = size});
    patches.emplace_back(window.triangles().begin(), window.triangles().end());
    patches.push_back(all);
    std::shuffle(patches.back().begin(), patches.back().end(), random);
    patches.back().resize(std::min<std::size_t>(all.size(), size));
  }
  std::erase_if(patches, [&](const auto& patch) { return edges_inside(mesh, patch).size() > 11; });
  return patches;
}

TEST(Window, IsTheLeastOfAllColoringsOfSmallMeshes) {
  std::mt19937 random(1);
  std::size_t compared = 0;
  for (StripMesh& mesh : sample::tiny_meshes())
    for (const double share : {0.0, 0.7, 1.0}) {
      sample::color_at_random(mesh, share, random);
      compared += expect_least(mesh, moves::all_triangles(mesh), random());
      ASSERT_FALSE(HasFailure());
    }
  EXPECT_GT(compared, 500U);
}

TEST(Window, IsTheLeastOfAllColoringsOfSmallPatches) {
  std::mt19937 random(2);
  std::vector<StripMesh> meshes{sample::torus(5, 4), sample::rectangle(6, 4), sample::tube(4, 4), sample::sphere(1)};
  std::size_t compared = 0;
  for (StripMesh& mesh : meshes)
    for (int round = 0; round < 20; ++round) {
      sample::color_at_random(mesh, round % 4 == 0 ? 0.6 : 1.0, random);
      if (round % 5 == 0) stripify(mesh, Effort::fast, Cost::indices());
      for (const std::vector<Triangle>& patch : small_patches(mesh, random)) {
        compared += expect_least(mesh, patch, random());
        ASSERT_FALSE(HasFailure());
      }
    }
  EXPECT_GT(compared, 15'000U);
}

// Long strips that leave a window and come back, on larger meshes; every change is reported.
TEST(Window, IsNeverWorseThanBefore) {
  std::mt19937 random(3);
  std::vector<StripMesh> meshes = sample::meshes();
  meshes.push_back(sample::torus(30, 20));
  meshes.push_back(sample::rectangle(25, 20));
  constexpr std::size_t windows_each = 100;
  std::size_t windows = 0;
  for (StripMesh& mesh : meshes)
    for (const Cost cost : window_costs)
      for (const Effort effort : {Effort::fast, Effort::full}) {
        stripify(mesh, effort, effort == Effort::fast ? Cost::strips() : cost, 5'000);
        Window window(cost, random());
        Counted count = counted(mesh);
        const std::vector<Triangle> all = moves::all_triangles(mesh);
        for (std::size_t i = 0; i < windows_each; ++i) {
          const auto size = static_cast<std::uint32_t>(1 + random() % 50);
          const WindowChange done = window.around(mesh, all[random() % all.size()], {.triangles = size});
          ASSERT_LE(price({done.change, done.windings}, cost, Windings::priced), 0);
          count.colors += done.change;
          count.windings += done.windings;
          ++windows;
        }
        const Counted after = counted(mesh);
        EXPECT_TRUE(check_coloring(mesh).valid);
        EXPECT_EQ(after.colors, count.colors);
        EXPECT_EQ(after.windings, count.windings);
        EXPECT_EQ(window.counts().windows, windows_each);
        EXPECT_EQ(window.counts().refused, 0U);
      }
  EXPECT_EQ(windows, meshes.size() * window_costs.size() * 2 * windows_each);
}

}  // namespace
}  // namespace restrip
