// Small and middle-sized meshes for tests: closed, with boundary, with several components, with handles, with vertices
// of valence two.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <random>
#include <vector>

#include "restrip/mesh/strip_mesh.hpp"

namespace restrip::sample {

using Corners = std::array<Vertex, 3>;

// The triangles of the mesh, each from its smallest corner, in order: equal meshes are equal lists.
inline std::vector<Corners> triangles_of(const StripMesh& mesh) {
  std::vector<Corners> triangles;
  for (Triangle t = 0; t < mesh.triangle_bound(); ++t) {
    if (!mesh.alive(t)) continue;
    Corners c = mesh.corners(t);
    std::rotate(c.begin(), std::min_element(c.begin(), c.end()), c.end());
    triangles.push_back(c);
  }
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

// All dual edges, each from one side.
inline std::vector<StripMesh::Halfedge> dual_edges(const StripMesh& mesh) {
  std::vector<StripMesh::Halfedge> edges;
  for (Triangle t = 0; t < mesh.triangle_bound(); ++t)
    for (unsigned side = 0; mesh.alive(t) && side < 3; ++side)
      if (const StripMesh::Halfedge h = StripMesh::halfedge(t, side); h.id < mesh.opposite(h).id)
        if (!StripMesh::on_boundary(mesh.opposite(h))) edges.push_back(h);
  return edges;
}

// Those whose colours differ between two colourings of the same mesh.
inline std::vector<StripMesh::Halfedge> recolored_edges(const StripMesh& one, const StripMesh& other) {
  std::vector<StripMesh::Halfedge> edges = dual_edges(one);
  std::erase_if(edges, [&](StripMesh::Halfedge h) { return one.solid(h) == other.solid(h); });
  return edges;
}

inline StripMesh octahedron() {
  const std::vector<Corners> t{{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  return StripMesh::build(t, 6);
}

// A cone of `k` triangles around vertex 0, closed below by a second apex: one vertex of a chosen valence.
inline StripMesh double_cone(Vertex k) {
  std::vector<Corners> triangles;
  for (Vertex i = 0; i < k; ++i) {
    triangles.push_back({0, 2 + i, 2 + (i + 1) % k});
    triangles.push_back({1, 2 + (i + 1) % k, 2 + i});
  }
  return StripMesh::build(triangles, k + 2);
}

// A double cone from which a wedge is cut: both apexes have open fans of k triangles, with triangles outside all ports.
inline StripMesh open_double_cone(Vertex k) {
  std::vector<Corners> triangles;
  for (Vertex i = 0; i < k; ++i) {
    triangles.push_back({0, 2 + i, 3 + i});
    triangles.push_back({1, 3 + i, 2 + i});
  }
  return StripMesh::build(triangles, k + 3);
}

// A grid of columns x rows quadrilaterals, each cut along a diagonal drawn at random. Each direction may be closed:
// none gives a rectangle, one a tube, both a torus.
inline std::vector<Corners> grid(Vertex columns, Vertex rows, bool close_x, bool close_y, unsigned seed) {
  std::mt19937 random(seed);
  const Vertex width = close_x ? columns : columns + 1;
  const Vertex height = close_y ? rows : rows + 1;
  std::vector<Corners> triangles;
  for (Vertex y = 0; y < rows; ++y) {
    for (Vertex x = 0; x < columns; ++x) {
      const Vertex x1 = (x + 1) % width;
      const Vertex y1 = (y + 1) % height;
      const Vertex a = y * width + x;
      const Vertex b = y * width + x1;
      const Vertex c = y1 * width + x1;
      const Vertex d = y1 * width + x;
      if ((random() & 1U) != 0) {
        triangles.push_back({a, b, c});
        triangles.push_back({a, c, d});
      } else {
        triangles.push_back({a, b, d});
        triangles.push_back({b, c, d});
      }
    }
  }
  return triangles;
}

inline StripMesh rectangle(Vertex columns, Vertex rows, unsigned seed = 1) {
  return StripMesh::build(grid(columns, rows, false, false, seed), std::size_t{columns + 1} * (rows + 1));
}
inline StripMesh torus(Vertex columns, Vertex rows, unsigned seed = 1) {
  return StripMesh::build(grid(columns, rows, true, true, seed), std::size_t{columns} * rows);
}
inline StripMesh tube(Vertex columns, Vertex rows, unsigned seed = 1) {
  return StripMesh::build(grid(columns, rows, true, false, seed), std::size_t{columns} * (rows + 1));
}

// A subdivided octahedron: closed, genus 0.
inline StripMesh sphere(unsigned subdivisions) {
  std::vector<Corners> triangles;
  {
    const StripMesh start = octahedron();
    for (Triangle t = 0; t < 8; ++t) triangles.push_back(start.corners(t));
  }
  Vertex vertices = 6;
  for (unsigned i = 0; i < subdivisions; ++i) {
    const StripMesh coarse = StripMesh::build(triangles, vertices);
    std::vector<std::array<Vertex, 3>> middle(coarse.triangle_bound());
    for (Triangle t = 0; t < coarse.triangle_bound(); ++t)
      for (unsigned s = 0; s < 3; ++s) {
        const StripMesh::Halfedge h = StripMesh::halfedge(t, s);
        const StripMesh::Halfedge g = coarse.opposite(h);
        if (h.id < g.id) middle[t][s] = middle[StripMesh::triangle(g)][StripMesh::side(g)] = vertices++;
      }
    triangles.clear();
    for (Triangle t = 0; t < coarse.triangle_bound(); ++t) {
      const auto [a, b, c] = coarse.corners(t);
      const auto [ab, bc, ca] = middle[t];
      for (const Corners& part : {Corners{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}})
        triangles.push_back(part);
    }
  }
  return StripMesh::build(triangles, vertices);
}

inline std::vector<StripMesh> meshes() {
  std::vector<StripMesh> all;
  all.push_back(octahedron());
  all.push_back(rectangle(9, 7));
  all.push_back(tube(8, 11));
  all.push_back(torus(12, 9));
  all.push_back(sphere(2));
  // Two triangles that share two edges (a vertex of valence two), and a mesh in two pieces.
  all.push_back(StripMesh::build(std::vector<Corners>{{0, 1, 2}, {1, 0, 2}, {3, 4, 5}, {4, 3, 6}}, 7));
  all.push_back(StripMesh::build(std::vector<Corners>{{0, 1, 3}, {1, 0, 3}, {0, 2, 1}, {2, 0, 4}, {1, 2, 4}}, 5));
  return all;
}

// All but the last, of which two vertices have two fans each.
inline std::vector<StripMesh> manifold_meshes() {
  std::vector<StripMesh> all = meshes();
  all.pop_back();
  return all;
}

}  // namespace restrip::sample
