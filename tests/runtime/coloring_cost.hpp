// The cost of a colouring, counted from its definition: along the listed strips, by the vertices that they turn around.
// Independent of how the library prices changes.
#pragma once

#include <gtest/gtest.h>

#include <array>

#include "restrip/mesh/cost.hpp"
#include "restrip/output/strips.hpp"

namespace restrip {

/// Strips, swaps and isolated triangles of a valid colouring.
inline ColoringChange cost_of(const StripMesh& mesh) {
  const Strips strips = extract_strips(mesh);
  EXPECT_EQ(strips.order.size(), mesh.triangle_count()) << "a solid cycle";
  ColoringChange cost;
  cost.strips = static_cast<int>(strips.size());
  for (std::size_t s = 0; s < strips.size(); ++s) {
    const auto strip = strips[s];
    cost.isolated += strip.size() == 1 ? 1 : 0;
    // The mesh edge between two triangles that follow each other, as two vertices.
    const auto edge_after = [&](std::size_t i) {
      for (unsigned side = 0; side < 3; ++side) {
        const StripMesh::Halfedge h = StripMesh::halfedge(strip[i], side);
        if (mesh.solid(h) && StripMesh::triangle(mesh.opposite(h)) == strip[i + 1])
          return std::array<Vertex, 2>{mesh.from(h), mesh.to(h)};
      }
      ADD_FAILURE() << "triangles that follow each other share no solid edge";
      return std::array<Vertex, 2>{};
    };
    // A strip goes through triangle i by two edges and turns around the vertex that they share.
    const auto pivot = [&](std::size_t i) {
      const auto in = edge_after(i - 1);
      const auto out = edge_after(i);
      return in[0] == out[0] || in[0] == out[1] ? in[0] : in[1];
    };
    for (std::size_t i = 1; i + 2 < strip.size(); ++i) cost.swaps += pivot(i) == pivot(i + 1) ? 1 : 0;
  }
  return cost;
}

inline ColoringChange operator-(const ColoringChange& a, const ColoringChange& b) {
  return {a.strips - b.strips, a.swaps - b.swaps, a.isolated - b.isolated};
}

}  // namespace restrip
