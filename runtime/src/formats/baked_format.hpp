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
/// Flips further away in the walk (DualOrder) are named by the halfedge itself.
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
  return {(std::min)(h.id, mesh.opposite(h).id)};
}

}  // namespace restrip::baked_format

namespace restrip {

/// Names for dual edges near a place: their numbers in a breadth-first walk. Nearby numbers are small, so files can
/// store them in few bytes. The walk starts with the triangles given, takes each triangle's sides 0, 1, 2, numbers a
/// dual edge when it first meets it, and continues with the triangles beyond in the order in which it met them.
class DualOrder {
 public:
  using Halfedge = StripMesh::Halfedge;

  /// Starts a walk from the triangles at the chord, left first.
  void start(const StripMesh& mesh, Halfedge chord) {
    mesh_ = &mesh;
    if (met_.size() < mesh.triangle_bound()) met_.resize(mesh.triangle_bound() + mesh.triangle_bound() / 2, 0);
    ++walk_;
    queue_.clear();
    edges_.clear();
    done_ = 0;
    for (const Halfedge h : {chord, mesh.opposite(chord)})
      if (!StripMesh::on_boundary(h)) meet(StripMesh::triangle(h));
  }

  /// Dual edge number n, by the halfedge it was met from; {none} if the walk ends earlier.
  [[nodiscard]] Halfedge edge(std::size_t n) {
    while (edges_.size() <= n && done_ < queue_.size()) expand();
    return n < edges_.size() ? edges_[n] : Halfedge{none};
  }

 private:
  // met_: 2 walk_ when met, and 2 walk_ + 1 when its sides have been numbered.
  void meet(Triangle t) {
    if (met_[t] >= 2 * walk_) return;
    met_[t] = 2 * walk_;
    queue_.push_back(t);
  }
  void expand() {
    const Triangle t = queue_[done_++];
    met_[t] = 2 * walk_ + 1;
    for (unsigned side = 0; side < 3; ++side) {
      const Halfedge h = StripMesh::halfedge(t, side);
      const Halfedge there = mesh_->opposite(h);
      if (StripMesh::on_boundary(there)) continue;
      const Triangle u = StripMesh::triangle(there);
      if (met_[u] != 2 * walk_ + 1) edges_.push_back(h);  // else it was met from the other side
      meet(u);
    }
  }

  const StripMesh* mesh_ = nullptr;
  std::vector<std::uint64_t> met_;
  std::uint64_t walk_ = 0;
  std::vector<Triangle> queue_;
  std::vector<Halfedge> edges_;
  std::size_t done_ = 0;
};

}  // namespace restrip
