// What the examples with a mesh of another library share: the mesh that they begin with, and what they compare, the
// triangles of the mesh and the triangles that the index buffer draws.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

/// Each triangle from its smallest corner on, in ascending order.
inline Triangles sorted(Triangles list) {
  for (auto& t : list) std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  std::sort(list.begin(), list.end());
  return list;
}

/// What a device draws of strips with primitive restart.
inline Triangles drawn(std::span<const std::uint32_t> indices) {
  Triangles list;
  std::size_t begin = 0;
  for (std::size_t i = 0; i < indices.size(); ++i) {
    if (indices[i] == 0xFFFFFFFF) {
      begin = i + 1;
    } else if (i >= begin + 2) {
      const bool odd = (i - begin) % 2 != 0;
      const std::array<std::uint32_t, 3> t{indices[i - 2], indices[odd ? i : i - 1], indices[odd ? i - 1 : i]};
      if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) list.push_back(t);
    }
  }
  return sorted(std::move(list));
}

struct StartMesh {
  std::vector<std::array<double, 3>> points;
  Triangles triangles;
};

/// A torus with bumps.
inline StartMesh bumpy_torus() {
  StartMesh torus;
  constexpr int columns = 60;
  constexpr int rows = 30;
  for (int y = 0; y < rows; ++y)
    for (int x = 0; x < columns; ++x) {
      const double u = 6.283185307 * x / columns;
      const double v = 6.283185307 * y / rows;
      const double around = 3 + std::cos(v) * (1 + 0.1 * std::sin(5 * u));
      torus.points.push_back({around * std::cos(u), around * std::sin(u), std::sin(v)});
      const auto at = [&](int dx, int dy) { return std::uint32_t((y + dy) % rows * columns + (x + dx) % columns); };
      torus.triangles.push_back({at(0, 0), at(1, 0), at(1, 1)});
      torus.triangles.push_back({at(0, 0), at(1, 1), at(0, 1)});
    }
  return torus;
}

/// As an index buffer.
inline std::vector<std::uint32_t> indices_of(const Triangles& list) {
  std::vector<std::uint32_t> indices;
  for (const auto& t : list) indices.insert(indices.end(), t.begin(), t.end());
  return indices;
}
