// Small meshes that are easy to imagine, and meshes in the text of a file.
#pragma once

#include <cmath>
#include <initializer_list>
#include <string>
#include <string_view>

#include "lod/mesh_formats.hpp"
#include "meshes/soup.hpp"
#include "restrip/search/stripify.hpp"

namespace restrip::tools {

inline std::string no_sibling(const std::string& /*file*/) { throw BadInput("f: other files do not exist"); }

/// The mesh of a file with this extension, alone in its folder.
inline Soup read_as(std::string_view extension, std::string_view bytes,
                    ReadAttributes attributes = ReadAttributes::no) {
  return finest_level(parse_mesh(bytes, extension, "some.file", no_sibling, attributes));
}

inline StripMesh mesh_of(const Soup& soup) { return StripMesh::build(soup.triangles, soup.points.size()); }

/// With greedy strips.
inline StripMesh stripified(const Soup& soup) {
  StripMesh mesh = mesh_of(soup);
  stripify(mesh, Effort::fast, Cost::strips());
  return mesh;
}

/// Closed, genus 0, four vertices.
inline Soup tetrahedron() {
  return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
}

/// A square sheet of n by n cells, two triangles a cell, slightly bent; one boundary loop of 4 n edges.
inline Soup sheet(std::uint32_t n) {
  Soup soup;
  for (std::uint32_t i = 0; i <= n; ++i)
    for (std::uint32_t j = 0; j <= n; ++j)
      soup.points.push_back(
          {static_cast<float>(i), static_cast<float>(j), static_cast<float>((i * 7 + j * j * 3) % 5) / 20.0F});
  const auto at = [n](std::uint32_t i, std::uint32_t j) { return i * (n + 1) + j; };
  for (std::uint32_t i = 0; i < n; ++i)
    for (std::uint32_t j = 0; j < n; ++j) {
      soup.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      soup.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  return soup;
}

/// n points on a circle of radius 1 at this height.
inline void add_circle(Soup& soup, std::uint32_t n, float height) {
  for (std::uint32_t i = 0; i < n; ++i) {
    const double angle = 6.283185307179586 * i / n;
    soup.points.push_back({static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle)), height});
  }
}

/// Two vertices of n triangles each, with a common rim.
inline Soup double_cone(std::uint32_t n) {
  Soup soup;
  add_circle(soup, n, 0);
  soup.points.insert(soup.points.end(), {{0, 0, 1}, {0, 0, -1}});
  for (std::uint32_t i = 0; i < n; ++i) {
    soup.triangles.push_back({i, (i + 1) % n, n});
    soup.triangles.push_back({(i + 1) % n, i, n + 1});
  }
  return soup;
}

/// One vertex of n - 1 triangles, its fan open.
inline Soup open_cone(std::uint32_t n) {
  Soup soup;
  add_circle(soup, n, 0);
  soup.points.push_back({0, 0, 1});
  for (std::uint32_t i = 0; i + 1 < n; ++i) soup.triangles.push_back({i, i + 1, n});
  return soup;
}

/// A cylinder as CAD programs write it: walls in two rows, and each cap a fan of n triangles around its centre.
inline Soup cylinder(std::uint32_t n) {
  Soup soup;
  for (const float height : {0.0F, 1.0F, 2.0F}) add_circle(soup, n, height);
  soup.points.insert(soup.points.end(), {{0, 0, 0}, {0, 0, 2}});
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t j = (i + 1) % n;
    for (const std::uint32_t row : {0U, n}) {
      soup.triangles.push_back({row + i, row + j, row + n + j});
      soup.triangles.push_back({row + i, row + n + j, row + n + i});
    }
    soup.triangles.push_back({j, i, 3 * n});
    soup.triangles.push_back({2 * n + i, 2 * n + j, 3 * n + 1});
  }
  return soup;
}

/// Flat: a vertex of n triangles, and around it rows of n points each. Every collapse inside costs nothing.
inline Soup disc(std::uint32_t n, std::uint32_t rows) {
  Soup soup;
  for (std::uint32_t row = 0; row < rows; ++row) {
    add_circle(soup, n, 0);
    for (std::uint32_t i = row * n; i < (row + 1) * n; ++i) {
      soup.points[i].x *= static_cast<float>(row + 1);
      soup.points[i].y *= static_cast<float>(row + 1);
    }
  }
  soup.points.push_back({0, 0, 0});
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t j = (i + 1) % n;
    soup.triangles.push_back({i, j, rows * n});
    for (std::uint32_t row = 0; row + 1 < rows; ++row) {
      soup.triangles.push_back({row * n + i, row * n + n + i, row * n + n + j});
      soup.triangles.push_back({row * n + i, row * n + n + j, row * n + j});
    }
  }
  return soup;
}

/// Two tetrahedra that share one vertex.
inline Soup bow_tie() {
  Soup soup = tetrahedron();
  soup.points.insert(soup.points.end(), {{-1, 0, 0}, {0, -1, 0}, {0, 0, -1}});
  for (const Corners& t : tetrahedron().triangles) {
    const auto moved = [](std::uint32_t v) { return v == 0 ? 0 : v + 3; };
    soup.triangles.push_back({moved(t[0]), moved(t[1]), moved(t[2])});
  }
  return soup;
}

}  // namespace restrip::tools
