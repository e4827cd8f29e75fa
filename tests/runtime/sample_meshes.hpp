// Small and middle-sized meshes for tests: closed, with boundary, with several components, with handles, with vertices
// of valence two, with edges of more than two triangles, with one vertex of very many.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

#include "naive_patch.hpp"
#include "restrip/mesh/strip_mesh.hpp"
#include "restrip/mesh/walks.hpp"

namespace restrip::sample {

using Corners = std::array<Vertex, 3>;

// Each triangle from its smallest corner, the list in order: equal meshes are equal lists.
inline std::vector<Corners> sorted(std::vector<Corners> triangles) {
  for (Corners& c : triangles) std::rotate(c.begin(), std::min_element(c.begin(), c.end()), c.end());
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

inline std::vector<Corners> triangles_of(const StripMesh& mesh) {
  std::vector<Corners> triangles;
  for (Triangle t = 0; t < mesh.triangle_bound(); ++t)
    if (mesh.alive(t)) triangles.push_back(mesh.corners(t));
  return sorted(std::move(triangles));
}

// The three sides of every triangle.
inline std::vector<StripMesh::Halfedge> sides_of(const StripMesh& mesh) {
  std::vector<StripMesh::Halfedge> sides;
  for (Triangle t = 0; t < mesh.triangle_bound(); ++t)
    for (unsigned side = 0; mesh.alive(t) && side < 3; ++side) sides.push_back(StripMesh::halfedge(t, side));
  return sides;
}

// All dual edges, each from one side.
inline std::vector<StripMesh::Halfedge> dual_edges(const StripMesh& mesh) {
  std::vector<StripMesh::Halfedge> edges = sides_of(mesh);
  std::erase_if(edges, [&](StripMesh::Halfedge h) {
    return StripMesh::on_boundary(mesh.opposite(h)) || mesh.opposite(h).id < h.id;
  });
  return edges;
}

// The halfedges that leave a manifold vertex, boundary spokes included.
inline std::vector<StripMesh::Halfedge> spokes_around(const StripMesh& mesh, Vertex v) {
  std::vector<StripMesh::Halfedge> spokes;
  for_each_spoke(mesh, v, [&](StripMesh::Halfedge h) { spokes.push_back(h); });
  return spokes;
}

// The solid sides of every triangle, by its number; 0 if it does not exist.
inline std::vector<std::uint8_t> colors_of(const StripMesh& mesh) {
  std::vector<std::uint8_t> colors(mesh.triangle_bound(), 0);
  for (Triangle t = 0; t < mesh.triangle_bound(); ++t)
    if (mesh.alive(t)) colors[t] = static_cast<std::uint8_t>(mesh.solid_sides(t));
  return colors;
}

// Dual edges whose colours differ between two colourings of the same mesh.
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
  const StripMesh start = octahedron();
  std::vector<Corners> triangles;
  for (Triangle t = 0; t < 8; ++t) triangles.push_back(start.corners(t));
  Vertex vertices = 6;
  for (unsigned i = 0; i < subdivisions; ++i) {
    const StripMesh coarse = StripMesh::build(triangles, vertices);
    std::vector<std::array<Vertex, 3>> middle(coarse.triangle_bound());
    for (const StripMesh::Halfedge h : dual_edges(coarse)) {
      const StripMesh::Halfedge g = coarse.opposite(h);
      middle[StripMesh::triangle(h)][StripMesh::side(h)] = middle[StripMesh::triangle(g)][StripMesh::side(g)] =
          vertices++;
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

inline StripMesh tetrahedron() {
  return StripMesh::build(std::vector<Corners>{{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}}, 4);
}

inline std::vector<StripMesh> meshes() {
  // The last two: two triangles that share two edges (a vertex of valence two), and a mesh in two pieces.
  return {octahedron(),
          rectangle(9, 7),
          tube(8, 11),
          torus(12, 9),
          sphere(2),
          StripMesh::build(std::vector<Corners>{{0, 1, 2}, {1, 0, 2}, {3, 4, 5}, {4, 3, 6}}, 7),
          StripMesh::build(std::vector<Corners>{{0, 1, 3}, {1, 0, 3}, {0, 2, 1}, {2, 0, 4}, {1, 2, 4}}, 5)};
}

// Meshes of at most 15 dual edges, so at most 2^15 colourings.
inline std::vector<StripMesh> tiny_meshes() {
  std::vector<StripMesh> all{octahedron(), double_cone(2), double_cone(3), rectangle(3, 2), tube(3, 2)};
  for (StripMesh& mesh : meshes())
    if (mesh.triangle_count() < 8) all.push_back(std::move(mesh));
  return all;
}

// All but the last, of which two vertices have two fans each.
inline std::vector<StripMesh> manifold_meshes() {
  std::vector<StripMesh> all = meshes();
  all.pop_back();
  return all;
}

// Colours the mesh again: dual edges become solid in random order wherever that keeps the colouring valid, with the
// given probability.
template <class Random>
void color_at_random(StripMesh& mesh, double share, Random& random) {
  mesh.clear_colors();
  std::vector<StripMesh::Halfedge> edges = dual_edges(mesh);
  std::shuffle(edges.begin(), edges.end(), random);
  naive::UnionFind strips(mesh.triangle_bound());
  for (const StripMesh::Halfedge h : edges) {
    const Triangle a = StripMesh::triangle(h);
    const Triangle b = StripMesh::triangle(mesh.opposite(h));
    if (mesh.solid_degree(a) > 1 || mesh.solid_degree(b) > 1 || strips.find(a) == strips.find(b)) continue;
    if (std::uniform_real_distribution<>()(random) > share) continue;
    strips.unite(a, b);
    mesh.set_solid(h, true);
  }
}

// ---- edges of more than two triangles: two-sided sheets, books, boxes that share an edge

using Triangles = std::vector<Corners>;

/// `columns` times `rows` squares on vertices that `at` numbers.
template <class At>
Triangles sheet(Vertex columns, Vertex rows, At&& at) {
  Triangles made;
  for (Vertex x = 0; x < columns; ++x)
    for (Vertex y = 0; y < rows; ++y) {
      made.push_back({at(x, y), at(x + 1, y), at(x + 1, y + 1)});
      made.push_back({at(x, y), at(x + 1, y + 1), at(x, y + 1)});
    }
  return made;
}
/// The list, and every triangle again with the opposite winding.
inline Triangles with_backs(Triangles list) {
  for (std::size_t t = 0, size = list.size(); t < size; ++t) list.push_back({list[t][1], list[t][0], list[t][2]});
  return list;
}
/// Sheets that share the column 0; with three pages, three sheets on one edge.
inline Triangles book(Vertex pages) {
  Triangles all;
  for (Vertex p = 0; p < pages; ++p) {
    const Triangles page = sheet(9, 12, [p](Vertex x, Vertex y) { return x == 0 ? y : 13 * (9 * p + x) + y; });
    all.insert(all.end(), page.begin(), page.end());
  }
  return all;
}
/// A band with half a turn: its ends are joined with opposite windings.
inline Triangles band(Vertex length) {
  Triangles made;
  for (Vertex x = 0; x < length; ++x) {
    const bool turned = x + 1 == length;
    const Vertex a = 2 * x;
    const Vertex b = turned ? 1 : 2 * x + 2;
    const Vertex c = turned ? 0 : 2 * x + 3;
    made.insert(made.end(), {{a, b, a + 1}, {a + 1, b, c}});
  }
  return made;
}
/// Boxes of 4 x 4 squares a side that all have one edge in common.
inline Triangles boxes(Vertex count) {
  constexpr Vertex n = 4;
  Triangles all;
  for (Vertex box = 0; box < count; ++box) {
    const auto at = [box](Vertex x, Vertex y, Vertex z) {
      return (x == 0 && y == 0 ? 0 : 125 * box) + x + 5 * y + 25 * z;
    };
    for (const Triangles& side : {sheet(n, n, [&](Vertex x, Vertex y) { return at(y, x, 0); }),
                                  sheet(n, n, [&](Vertex x, Vertex y) { return at(x, y, n); }),
                                  sheet(n, n, [&](Vertex x, Vertex y) { return at(x, 0, y); }),
                                  sheet(n, n, [&](Vertex x, Vertex y) { return at(y, n, x); }),
                                  sheet(n, n, [&](Vertex x, Vertex y) { return at(0, y, x); }),
                                  sheet(n, n, [&](Vertex x, Vertex y) { return at(n, x, y); })})
      all.insert(all.end(), side.begin(), side.end());
  }
  return all;
}

// ---- one vertex of very many triangles, against time quadratic in the valence

struct HubMesh {
  const char* name;
  std::vector<Corners> triangles;
  Vertex vertices;
};

/// n triangles that share vertex 0 and no edge.
inline HubMesh pinched(Vertex n) {
  HubMesh mesh{"pinched", {}, 2 * n + 1};
  for (Vertex i = 0; i < n; ++i) mesh.triangles.push_back({0, 2 * i + 1, 2 * i + 2});
  return mesh;
}

/// A double cone over n vertices, its triangles in random order.
inline HubMesh shuffled_double_cone(Vertex n) {
  HubMesh mesh{"double cone", {}, n + 2};
  for (Vertex i = 0; i < n; ++i) {
    mesh.triangles.push_back({0, 2 + i, 2 + (i + 1) % n});
    mesh.triangles.push_back({1, 2 + (i + 1) % n, 2 + i});
  }
  std::mt19937 random(7);
  for (std::size_t i = mesh.triangles.size(); i > 1; --i)
    std::swap(mesh.triangles[i - 1], mesh.triangles[random() % i]);
  return mesh;
}

/// A cone over n vertices with two rings around it, whose strips get as long as the rings.
inline HubMesh cone_with_rings(Vertex n) {
  HubMesh mesh{"cone with rings", {}, 3 * n + 1};
  for (Vertex i = 0; i < n; ++i) {
    const Vertex j = (i + 1) % n;
    mesh.triangles.push_back({0, 1 + i, 1 + j});
    for (const Vertex ring : {1U, 1 + n}) {
      mesh.triangles.push_back({ring + i, ring + n + i, ring + n + j});
      mesh.triangles.push_back({ring + i, ring + n + j, ring + j});
    }
  }
  return mesh;
}

inline std::vector<HubMesh> hub_meshes(Vertex n) { return {pinched(n), shuffled_double_cone(n), cone_with_rings(n)}; }

}  // namespace restrip::sample
