// The checksum is FNV-1a as its authors give it; the names of apexes and dual edges are as in
// docs/reference/file-formats.md.
#include "restrip/formats/baked_format.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <set>
#include <span>
#include <string_view>
#include <vector>

#include "sample_meshes.hpp"

namespace restrip::baked_format {
namespace {

constexpr std::uint64_t hash(std::string_view text) { return fnv1a(std::span<const char>(text)); }

// From the authors' test vectors (draft-eastlake-fnv, appendix C).
static_assert(hash("") == 0xCBF29CE484222325U);
static_assert(hash("a") == 0xAF63DC4C8601EC8CU);
static_assert(hash("foobar") == 0x85944171F73967E8U);
static_assert(magic.size() + 4 * sizeof(std::uint32_t) == header_bytes);

TEST(BakedFormat, NeighborsComeFromTheTrianglesInAscendingOrder) {
  for (const StripMesh& mesh : sample::manifold_meshes()) {
    std::vector<Vertex> named;
    for (Vertex v = 0; v < mesh.vertex_bound(); ++v) {
      std::set<Vertex> around;
      for (const sample::Corners& c : sample::triangles_of(mesh))
        if (c[0] == v || c[1] == v || c[2] == v) around.insert(c.begin(), c.end());
      if (around.empty()) continue;
      around.erase(v);
      neighbors_of(mesh, v, named);
      EXPECT_EQ(std::set<Vertex>(named.begin(), named.end()), around);
      EXPECT_TRUE(std::is_sorted(named.begin(), named.end()));
    }
    for (Triangle t = 0; t < mesh.triangle_bound(); ++t)
      for (unsigned side = 0; side < 3; ++side) {
        const StripMesh::Halfedge h = StripMesh::halfedge(t, side);
        if (StripMesh::on_boundary(mesh.opposite(h))) continue;
        EXPECT_EQ(canonical(mesh, h), canonical(mesh, mesh.opposite(h)));
        EXPECT_LE(canonical(mesh, h).id, h.id);
      }
  }
}

}  // namespace
}  // namespace restrip::baked_format
