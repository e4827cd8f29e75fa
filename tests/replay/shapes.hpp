// Small meshes that fit in the head.
#pragma once

#include "soup.hpp"

namespace restrip::replay {

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

}  // namespace restrip::replay
