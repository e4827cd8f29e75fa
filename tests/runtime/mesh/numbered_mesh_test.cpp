// A mesh that numbers its triangles and vertices is one for buffers; one that lacks any of the five functions is not.
// Numbers and halfedges name the same triangles, whatever the numbers begin at.
#include "restrip/mesh/numbered_mesh.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>

#include "../../support/half_edge_mesh.hpp"
#include "sample_meshes.hpp"

namespace restrip {
namespace {

struct NoBound : half_edge::Mesh {
  void triangle_bound() const {}
};
struct NoFrom : half_edge::Mesh {
  void from(Halfedge h) const = delete;
};
static_assert(NumberedMesh<StripMesh> && NumberedMesh<half_edge::Mesh>);
static_assert(!NumberedMesh<NoBound> && !NumberedMesh<NoFrom>);

template <NumberedMesh Mesh>
std::size_t triangles_numbered(const Mesh& mesh) {
  std::size_t count = 0;
  for (std::uint32_t t = 0; t < mesh.triangle_bound(); ++t) {
    if (!mesh.has_triangle(t)) continue;
    ++count;
    auto h = mesh.halfedge(t);
    for (int side = 0; side < 3; ++side, h = mesh.next(h)) {
      EXPECT_FALSE(mesh.on_boundary(h));
      EXPECT_EQ(mesh.triangle(h), t);
    }
    EXPECT_EQ(h, mesh.halfedge(t));
  }
  return count;
}

TEST(NumberedMeshes, NumbersNameTriangles) {
  for (const StripMesh& mesh : sample::manifold_meshes()) {
    EXPECT_EQ(triangles_numbered(mesh), mesh.triangle_count());
    EXPECT_EQ(triangles_numbered(half_edge::copy_of(mesh)), mesh.triangle_count());
  }
}

}  // namespace
}  // namespace restrip
