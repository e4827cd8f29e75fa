// Meshes in which one vertex has very many triangles, against time quadratic in the valence.
#pragma once

#include <array>
#include <cstdint>
#include <random>
#include <vector>

namespace restrip::sample {

struct HubMesh {
  const char* name;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::uint32_t vertices;
};

/// n triangles that share vertex 0 and no edge.
inline HubMesh pinched(std::uint32_t n) {
  HubMesh mesh{"pinched", {}, 2 * n + 1};
  for (std::uint32_t i = 0; i < n; ++i) mesh.triangles.push_back({0, 2 * i + 1, 2 * i + 2});
  return mesh;
}

/// A double cone over n vertices, its triangles in random order.
inline HubMesh shuffled_double_cone(std::uint32_t n) {
  HubMesh mesh{"double cone", {}, n + 2};
  for (std::uint32_t i = 0; i < n; ++i) {
    mesh.triangles.push_back({0, 2 + i, 2 + (i + 1) % n});
    mesh.triangles.push_back({1, 2 + (i + 1) % n, 2 + i});
  }
  std::mt19937 random(7);
  for (std::size_t i = mesh.triangles.size(); i > 1; --i)
    std::swap(mesh.triangles[i - 1], mesh.triangles[random() % i]);
  return mesh;
}

/// A cone over n vertices with two rings around it, whose strips get as long as the rings.
inline HubMesh cone_with_rings(std::uint32_t n) {
  HubMesh mesh{"cone with rings", {}, 3 * n + 1};
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t j = (i + 1) % n;
    mesh.triangles.push_back({0, 1 + i, 1 + j});
    for (const std::uint32_t ring : {1U, 1 + n}) {
      mesh.triangles.push_back({ring + i, ring + n + i, ring + n + j});
      mesh.triangles.push_back({ring + i, ring + n + j, ring + j});
    }
  }
  return mesh;
}

inline std::vector<HubMesh> hub_meshes(std::uint32_t n) {
  return {pinched(n), shuffled_double_cone(n), cone_with_rings(n)};
}

}  // namespace restrip::sample
