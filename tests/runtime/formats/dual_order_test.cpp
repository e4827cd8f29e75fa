// The walk numbers every dual edge of a connected mesh once, nearest first: the distance of its triangles from the
// start, counted by rings, never goes down.
#include "restrip/formats/dual_order.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <set>
#include <vector>

#include "restrip/mesh/walks.hpp"
#include "sample_meshes.hpp"

namespace restrip {
namespace {

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
        for (Triangle t = 0; t < mesh.triangle_bound(); ++t)
          for (unsigned s = 0; s < 3; ++s)
            if (const auto h = StripMesh::halfedge(t, s); !StripMesh::on_boundary(mesh.opposite(h)))
              all.insert(std::min(h.id, mesh.opposite(h).id));
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
}  // namespace restrip
