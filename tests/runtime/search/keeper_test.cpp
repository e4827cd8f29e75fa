// Tunnelling joins strips and never harms a colouring; a keeper's strips, counts and locator are right after any
// mixture of operations, and they stay few.
#include "restrip/search/keeper.hpp"

#include <gtest/gtest.h>

#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "locator_agrees.hpp"
#include "random_operation.hpp"
#include "restrip/output/strips.hpp"
#include "restrip/search/stripify.hpp"
#include "sample_meshes.hpp"

namespace restrip {
namespace {

using Halfedge = StripMesh::Halfedge;

void expect_right(const StripMesh& mesh, const StripLocator& locator) {
  ASSERT_TRUE(check_coloring(mesh).valid);
  ASSERT_TRUE(agrees(locator, mesh));
}

void expect_right(const StripKeeper& keeper) {
  if (keeper.locator() != nullptr) {
    expect_right(keeper.mesh(), *keeper.locator());
    return;
  }
  const ColoringReport report = check_coloring(keeper.mesh());
  ASSERT_TRUE(report.valid);
  ASSERT_EQ(report.strips, keeper.strips());
}

TEST(Tunnel, EachJoinTakesOneStripAway) {
  for (StripMesh& mesh : sample::meshes()) {
    StripLocator locator(mesh);  // all isolated
    Tunnel tunnel;
    for (Triangle t = 0; t < mesh.triangle_bound(); ++t) {
      const std::size_t before = locator.strips();
      const bool joined = tunnel.join(mesh, locator, t, 20);
      ASSERT_EQ(locator.strips(), before - (joined ? 1 : 0));
      expect_right(mesh, locator);
    }
    for (Triangle t = 0; t < mesh.triangle_bound(); ++t) {
      const std::size_t before = locator.strips();
      const bool joined = tunnel.join(mesh, locator, t, 50, Tunnel::OnFailure::wander);
      ASSERT_EQ(locator.strips(), before - (joined ? 1 : 0));
      expect_right(mesh, locator);
    }
  }
}

TEST(Tunnel, LooksAtNoMoreStatesThanAllowed) {
  StripMesh mesh = sample::torus(30, 30);
  stripify(mesh);
  StripLocator locator(mesh);
  for (const std::uint32_t states : {0U, 1U, 2U, 7U, 100U}) {
    Tunnel tunnel;
    for (Triangle t = 0; t < mesh.triangle_bound(); ++t) tunnel.join(mesh, locator, t, states);
    EXPECT_LE(tunnel.counts().states, tunnel.counts().searches * states);
  }
}

TEST(StripifyFull, ReachesOneStripOnClosedMeshes) {
  StripMesh sphere = sample::sphere(4);
  EXPECT_EQ(stripify(sphere, Effort::full), 1U);
  EXPECT_EQ(check_coloring(sphere).strips, 1U);
  StripMesh torus = sample::torus(60, 50);
  EXPECT_EQ(stripify(torus, Effort::full), 1U);
  EXPECT_TRUE(check_coloring(torus).valid);
}

TEST(StripifyFull, IsValidAndTheSameEveryTime) {
  for (StripMesh& mesh : sample::meshes()) {
    const std::size_t strips = stripify(mesh, Effort::full, 5000);
    const ColoringReport report = check_coloring(mesh);
    EXPECT_TRUE(report.valid);
    EXPECT_EQ(report.strips, strips);
    EXPECT_GE(strips, connected_components(mesh));
    const Strips first = extract_strips(mesh);
    EXPECT_EQ(stripify(mesh, Effort::full, 5000), strips);
    EXPECT_EQ(extract_strips(mesh).order, first.order);
  }
}

TEST(StripKeeper, ChangesItsPolicyOnTheWay) {
  std::mt19937 random(8);
  StripMesh mesh = sample::torus(12, 12);
  StripKeeper keeper(mesh, Policy::linked);
  EXPECT_EQ(keeper.strips(), mesh.triangle_count());
  for (const Policy policy : {Policy::quick, Policy::local, Policy::full, Policy::linked, Policy::quick}) {
    keeper.set_policy(policy);
    for (int i = 0; i < 100; ++i) random_operation(keeper, random, i % 2 == 0);
    expect_right(keeper);
    keeper.improve(100);
    expect_right(keeper);
  }
}

TEST(StripKeeper, IsRightAfterEveryOperation) {
  std::mt19937 random(6);
  for (const Policy policy : {Policy::local, Policy::linked, Policy::quick, Policy::full}) {
    for (StripMesh& mesh : sample::meshes()) {
      StripKeeper keeper(mesh, policy);
      for (int i = 0; i < 400; ++i) {
        random_operation(keeper, random, mesh.triangle_count() < 60 || (i / 80) % 2 == 0);
        if (i % 97 == 0) keeper.improve(200);
        expect_right(keeper);
        if (HasFatalFailure()) return;
      }
    }
  }
}

std::size_t strips_from_scratch(StripMesh mesh) { return stripify(mesh, Effort::full, mesh.triangle_count() * 10); }

// Random operations make meshes on which no stripification is perfect: strips from scratch are the measure.
TEST(StripKeeper, StripsDoNotAge) {
  std::mt19937 random(7);
  StripMesh mesh = sample::torus(60, 60);
  stripify(mesh, Effort::full);
  StripKeeper keeper(mesh, Policy::quick);
  const auto allowed = [&](std::size_t triangles_per_strip) {
    return strips_from_scratch(mesh) + mesh.triangle_count() / triangles_per_strip;
  };
  for (int round = 0; round < 6; ++round) {
    for (int done = 0; done < 1500;) done += random_operation(keeper, random, round % 2 == 0) ? 1 : 0;
    expect_right(keeper);
    EXPECT_LE(keeper.strips(), allowed(60)) << "round " << round;
  }
  keeper.set_policy(Policy::full);
  for (int round = 0; round < 4; ++round) {
    for (int done = 0; done < 1500;) done += random_operation(keeper, random, round % 2 == 0) ? 1 : 0;
    EXPECT_LE(keeper.strips(), allowed(120)) << "round " << round;
  }
  keeper.improve(mesh.triangle_count() * 10);
  EXPECT_LE(keeper.strips(), allowed(1000));
  expect_right(keeper);
}

// A ring of solid edges has no end from which its triangles could be numbered, and a triangle of three solid edges no
// strip.
TEST(InvalidColorings, AreRefusedByWhoeverReadsTheWholeMesh) {
  for (const bool cycle : {true, false}) {
    StripMesh mesh = sample::rectangle(3, 3);
    if (cycle) {
      for_each_spoke(mesh, 5, [&](Halfedge h) { mesh.set_solid(h, true); });
    } else {
      Triangle t = 0;
      const auto inner = [&](unsigned side) {
        return !StripMesh::on_boundary(mesh.opposite(StripMesh::halfedge(t, side)));
      };
      while (!inner(0) || !inner(1) || !inner(2)) ++t;
      for (unsigned side = 0; side < 3; ++side) mesh.set_solid(StripMesh::halfedge(t, side), true);
    }
    ASSERT_FALSE(check_coloring(mesh).valid);
    const auto message = [&](const auto& read) -> std::string {
      try {
        read();
      } catch (const std::invalid_argument& error) {
        return error.what();
      }
      return "nothing thrown";
    };
    const std::string expected = std::string("restrip: the colouring is not valid: ") +
                                 (cycle ? "solid dual edges close a cycle" : "a triangle has three solid dual edges");
    for (const Policy policy : {Policy::local, Policy::linked, Policy::quick, Policy::full})
      EXPECT_EQ(message([&] { const StripKeeper keeper(mesh, policy); }), expected);
    EXPECT_EQ(message([&] { const StripLocator locator(mesh); }), expected);
    EXPECT_EQ(message([&] { (void)count_strips(mesh); }), expected);
    mesh.clear_colors();
    StripKeeper keeper(mesh);
    EXPECT_EQ(keeper.strips(), mesh.triangle_count());
    EXPECT_EQ(count_strips(mesh), mesh.triangle_count());
  }
}

}  // namespace
}  // namespace restrip
