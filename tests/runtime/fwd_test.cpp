// The forward declarations are enough for a class that holds a LiveMesh: its header includes nothing else.
#include "restrip/fwd.hpp"

#include <cstddef>
#include <memory>

namespace {

struct Terrain {
  Terrain();
  std::unique_ptr<restrip::LiveMesh> live;
  [[nodiscard]] static std::size_t triangles(const restrip::StripMesh& mesh);
  [[nodiscard]] static std::size_t strips(const restrip::Keeper& keeper);
  [[nodiscard]] static std::size_t room(const restrip::LiveBuffer& buffer);
};

}  // namespace

#include <gtest/gtest.h>

#include "restrip/live_mesh.hpp"
#include "restrip/output/live_buffer.hpp"
#include "restrip/search/keeper.hpp"
#include "sample_meshes.hpp"

namespace {

Terrain::Terrain() : live(std::make_unique<restrip::LiveMesh>(restrip::sample::octahedron())) {}
std::size_t Terrain::triangles(const restrip::StripMesh& mesh) { return mesh.triangle_count(); }
std::size_t Terrain::strips(const restrip::Keeper& keeper) { return keeper.strips(); }
std::size_t Terrain::room(const restrip::LiveBuffer& buffer) { return buffer.room(); }

TEST(Fwd, IsEnoughForAMember) {
  Terrain terrain;
  EXPECT_EQ(Terrain::triangles(terrain.live->mesh()), 8U);
  EXPECT_EQ(Terrain::strips(terrain.live->keeper()), terrain.live->strips());
  EXPECT_EQ(Terrain::room(terrain.live->buffer()), terrain.live->room());
}

// The documented defaults; each effort comes after the ones that do less.
TEST(Fwd, DefaultsAndOrder) {
  EXPECT_EQ(restrip::default_policy, restrip::Policy::quick);
  EXPECT_EQ(restrip::default_effort, restrip::Effort::fast);
  EXPECT_LT(restrip::Effort::fast, restrip::Effort::full);
  EXPECT_LT(restrip::Effort::full, restrip::Effort::best);
}

}  // namespace
