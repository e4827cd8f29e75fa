// A restrip_mesh that frees itself, made of a StripMesh, and its state as seen through the interface.
#pragma once

#include <gtest/gtest.h>
#include <restrip.h>

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "restrip/mesh/strip_mesh.hpp"
#include "runtime/sample_meshes.hpp"

namespace restrip::c_test {

struct Free {
  void operator()(restrip_mesh* mesh) const { restrip_mesh_free(mesh); }
};
using Handle = std::unique_ptr<restrip_mesh, Free>;

inline std::vector<std::uint32_t> list_of(const StripMesh& mesh) {
  std::vector<std::uint32_t> indices;
  for (Triangle t = 0; t < mesh.triangle_bound(); ++t)
    for (const Vertex v : mesh.corners(t)) indices.push_back(v);
  return indices;
}

/// The mesh must have no removed triangles.
inline Handle handle_of(const StripMesh& mesh) {
  const auto indices = list_of(mesh);
  restrip_mesh* made = nullptr;
  EXPECT_EQ(restrip_mesh_build_u32(indices.data(), indices.size(), mesh.vertex_bound(), nullptr, nullptr, &made),
            RESTRIP_OK);
  return Handle(made);
}

inline constexpr restrip_cost fewest_strips = RESTRIP_FEWEST_STRIPS;

inline std::vector<std::uint8_t> colors_of(const restrip_mesh* mesh) {
  std::vector<std::uint8_t> colors(restrip_mesh_triangle_bound(mesh) + 1);  // never an array of null
  EXPECT_EQ(restrip_mesh_get_colors(mesh, colors.data(), colors.size()), RESTRIP_OK);
  colors.pop_back();
  return colors;
}
using sample::colors_of;

/// Every triangle by its number; {RESTRIP_NONE, …} if it does not exist.
inline std::vector<std::array<std::uint32_t, 3>> corners_of(const restrip_mesh* mesh) {
  std::vector<std::array<std::uint32_t, 3>> all(restrip_mesh_triangle_bound(mesh));
  for (std::uint32_t t = 0; t < all.size(); ++t)
    if (restrip_mesh_corners(mesh, t, all[t].data()) != RESTRIP_OK) all[t].fill(RESTRIP_NONE);
  return all;
}
inline std::vector<std::array<std::uint32_t, 3>> corners_of(const StripMesh& mesh) {
  std::vector<std::array<std::uint32_t, 3>> all(mesh.triangle_bound());
  for (Triangle t = 0; t < all.size(); ++t) all[t] = mesh.corners(t);
  return all;
}

inline restrip_coloring counted(const restrip_mesh* mesh) {
  restrip_coloring found{};
  EXPECT_EQ(restrip_mesh_check(mesh, &found), RESTRIP_OK);
  EXPECT_EQ(found.valid, 1);
  EXPECT_EQ(found.triangles, restrip_mesh_triangle_count(mesh));
  return found;
}
inline std::size_t strip_count(const restrip_mesh* mesh) {
  std::size_t strips = 0;
  EXPECT_EQ(restrip_mesh_strip_count(mesh, &strips), RESTRIP_OK);
  return strips;
}
inline restrip_status begin_live(restrip_mesh* mesh, std::int32_t form, std::int32_t bits, std::size_t history = 0) {
  const restrip_format format{form, bits, 0, 0, 1};
  return restrip_live_begin(mesh, &format, nullptr, history);
}
/// Updates the live buffer.
inline std::span<const restrip_range> updated(restrip_mesh* mesh) {
  const restrip_range* ranges = nullptr;
  std::size_t count = 0;
  EXPECT_EQ(restrip_live_update(mesh, 2, 4, &ranges, &count, nullptr), RESTRIP_OK);
  return {ranges, count};
}
}  // namespace restrip::c_test
