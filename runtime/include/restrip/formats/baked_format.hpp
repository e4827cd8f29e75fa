// Shared by the reader and the writer of baked meshes. docs/reference/file-formats.md has the format.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "restrip/mesh/strip_mesh.hpp"
#include "restrip/mesh/walks.hpp"

namespace restrip::baked_format {

inline constexpr std::string_view magic = "RestripB";
/// Files are written as version 1, or with a payload, whose size is then part of the header, as version 2.
inline constexpr std::uint32_t version = 1;
inline constexpr std::uint32_t version_with_payload = 2;
inline constexpr std::size_t header_bytes = 24;
inline constexpr std::size_t checksum_bytes = 8;
inline constexpr std::size_t point_bytes = 12;
inline constexpr std::size_t triangle_bytes = 13;
inline constexpr std::size_t least_record_bytes = point_bytes + 3;
/// Flips further away in the walk (dual_order.hpp) are named by the halfedge itself.
inline constexpr std::size_t near_edges = 2048;

/// FNV-1a, 64 bits (Fowler, Noll, Vo): every step is a bijection of its state, so every change of a single byte is
/// detected. `Byte`: char or std::byte.
template <class Byte>
[[nodiscard]] constexpr std::uint64_t fnv1a(std::span<const Byte> bytes) noexcept {
  std::uint64_t hash = 0xCBF29CE484222325ULL;
  for (const Byte b : bytes) hash = (hash ^ static_cast<unsigned char>(b)) * 0x100000001B3ULL;
  return hash;
}

/// The vertices around v, in ascending order: the names of v_l and v_r are their places in this list.
inline void neighbors_of(const StripMesh& mesh, Vertex v, std::vector<Vertex>& out) {
  out.clear();
  for_each_spoke(mesh, v, [&](StripMesh::Halfedge h) { out.push_back(mesh.to(h)); });
  std::sort(out.begin(), out.end());
}

/// A dual edge by the lower one of its two halfedges.
[[nodiscard]] inline StripMesh::Halfedge canonical(const StripMesh& mesh, StripMesh::Halfedge h) noexcept {
  return {std::min(h.id, mesh.opposite(h).id)};
}

}  // namespace restrip::baked_format
