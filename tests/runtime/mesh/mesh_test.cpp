// The concepts hold exactly for meshes with the members that they name, and optional steps of a mesh agree with the
// steps made of the five functions that every mesh has.
#include "restrip/mesh/mesh.hpp"

#include <gtest/gtest.h>

#include <random>

#include "../../support/half_edge_mesh.hpp"
#include "sample_meshes.hpp"

namespace restrip {
namespace {

/// A StripMesh with nothing but the five functions.
class FiveFunctions {
 public:
  using Halfedge = StripMesh::Halfedge;
  explicit FiveFunctions(StripMesh& mesh) : mesh_(&mesh) {}
  [[nodiscard]] Halfedge next(Halfedge h) const { return StripMesh::next(h); }
  [[nodiscard]] Halfedge opposite(Halfedge h) const { return mesh_->opposite(h); }
  [[nodiscard]] bool on_boundary(Halfedge h) const { return StripMesh::on_boundary(h); }
  [[nodiscard]] bool solid(Halfedge h) const { return mesh_->solid(h); }
  void set_solid(Halfedge h, bool solid) { mesh_->set_solid(h, solid); }

 private:
  StripMesh* mesh_;
};

static_assert(ColoredMesh<StripMesh> && SplittableMesh<StripMesh> && CollapsibleMesh<StripMesh>);
static_assert(FlippableMesh<StripMesh>);
static_assert(ColoredMesh<FiveFunctions> && !SplittableMesh<FiveFunctions> && !CollapsibleMesh<FiveFunctions>);
static_assert(!FlippableMesh<FiveFunctions>);
static_assert(SplittableMesh<half_edge::Mesh> && FlippableMesh<half_edge::OnlyFlips>);
static_assert(!SplittableMesh<half_edge::OnlyFlips> && !CollapsibleMesh<half_edge::OnlyFlips>);
static_assert(!ColoredMesh<const StripMesh>, "what cannot be coloured keeps no strips");

TEST(MeshSteps, AreMadeOfFiveFunctions) {
  std::mt19937 random(1);
  for (StripMesh& mesh : sample::meshes()) {
    sample::color_at_random(mesh, 0.8, random);
    const FiveFunctions plain(mesh);
    for (const StripMesh::Halfedge h : sample::sides_of(mesh)) {
      const auto fan = fan_step(mesh, h);
      const auto plain_fan = fan_step(plain, h);
      EXPECT_EQ(fan.port, plain_fan.port);
      EXPECT_EQ(fan.edge, plain_fan.edge);
      EXPECT_EQ(fan.spoke, plain_fan.spoke);
      EXPECT_EQ(turn_ccw(plain, h), fan.spoke);
      if (!StripMesh::on_boundary(fan.spoke)) {
        EXPECT_EQ(turn_cw(plain, fan.spoke), h);
      }
      EXPECT_EQ(mesh.from(turn_ccw(plain, h)), mesh.from(h));
      const auto strip = strip_step(mesh, h);
      const auto plain_strip = strip_step(plain, h);
      ASSERT_EQ(strip.continues, plain_strip.continues);
      if (!strip.continues) continue;
      EXPECT_EQ(strip.in, plain_strip.in);
      EXPECT_TRUE(mesh.solid(strip.in));
      EXPECT_EQ(StripMesh::triangle(mesh.opposite(strip.in)), StripMesh::triangle(h));
    }
  }
}

}  // namespace
}  // namespace restrip
