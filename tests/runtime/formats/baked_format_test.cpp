// The checksum is FNV-1a as its authors give it; the names of apexes and dual edges are as in
// docs/reference/file-formats.md.
#include "formats/baked_format.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <set>
#include <span>
#include <string_view>
#include <vector>

#include "restrip/mesh/walks.hpp"
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
    for (const StripMesh::Halfedge h : sample::dual_edges(mesh)) {
      EXPECT_EQ(canonical(mesh, h), h);
      EXPECT_EQ(canonical(mesh, mesh.opposite(h)), h);
    }
  }
}

// The walk numbers every dual edge of a connected mesh once, nearest first: the distance of its triangles from the
// start, counted by rings, never goes down.
TEST(DualOrder, NumbersEveryDualEdgeOnceAndNearestFirst) {
  DualOrder order;  // one for all: a walk does not affect the next
  for (const StripMesh& mesh : {sample::octahedron(), sample::rectangle(9, 7), sample::torus(12, 9), sample::sphere(2)})
    for (const Triangle from : {Triangle{0}, static_cast<Triangle>(mesh.triangle_bound() - 1)})
      for (unsigned side = 0; side < 3; ++side) {
        const StripMesh::Halfedge chord = StripMesh::halfedge(from, side);
        std::vector<std::size_t> distance(mesh.triangle_bound(), mesh.triangle_bound());
        for (const StripMesh::Halfedge h : {chord, mesh.opposite(chord)})
          if (!StripMesh::on_boundary(h)) distance[StripMesh::triangle(h)] = 0;
        for (std::size_t ring = 0; ring < mesh.triangle_bound(); ++ring)
          for (Triangle t = 0; t < mesh.triangle_bound(); ++t)
            if (distance[t] == ring)
              for_each_neighbor(mesh, t, [&](Triangle u) { distance[u] = std::min(distance[u], ring + 1); });
        std::set<std::uint32_t> all;
        for (const StripMesh::Halfedge h : sample::dual_edges(mesh)) all.insert(h.id);
        order.start(mesh, chord);
        std::set<std::uint32_t> met;
        std::size_t reached = 0;
        for (std::size_t n = 0; order.edge(n).id != none; ++n) {
          const StripMesh::Halfedge h = order.edge(n);
          EXPECT_TRUE(met.insert(std::min(h.id, mesh.opposite(h).id)).second) << "twice";
          EXPECT_GE(distance[StripMesh::triangle(h)], reached);
          reached = distance[StripMesh::triangle(h)];
        }
        EXPECT_EQ(met, all);
      }
}

}  // namespace
}  // namespace restrip::baked_format
