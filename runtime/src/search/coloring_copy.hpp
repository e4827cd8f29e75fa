// A copy of the colours of a mesh, to be changed and written back.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "restrip/mesh/cost.hpp"
#include "restrip/mesh/strip_mesh.hpp"
#include "restrip/mesh/triangle_list.hpp"

namespace restrip::detail {

/// The part of a StripMesh that searches read, in 13 bytes a triangle; triangles do not change. Halfedges are numbered
/// as in the mesh, 4 * triangle + side.
class ColoringCopy {
 public:
  using Halfedge = StripMesh::Halfedge;

  explicit ColoringCopy(const StripMesh& mesh)
      : across_(mesh.triangle_bound()), alive_(mesh.triangle_bound(), false), solid_(mesh.triangle_bound(), 0) {
    for (Triangle t = 0; t < across_.size(); ++t) {
      across_[t] = {none, none, none};
      if (!mesh.alive(t)) continue;
      alive_[t] = true;
      ++triangles_;
      for (unsigned s = 0; s < 3; ++s) {
        const Halfedge there = mesh.opposite(StripMesh::halfedge(t, s));
        if (!StripMesh::on_boundary(there)) across_[t][s] = there.id;
      }
      solid_[t] = static_cast<std::uint8_t>(mesh.solid_sides(t));
    }
  }
  /// The triangles of a list, numbered as there, all dual edges dashed. Entries that find_neighbors() leaves out are
  /// not triangles.
  template <class Element>
  ColoringCopy(const TriangleList<Element>& list, std::size_t vertex_count)
      : across_(list.size()), alive_(list.size(), true), triangles_(list.size()), solid_(list.size(), 0) {
    BuildReport report;
    find_neighbors(list, vertex_count, across_, report);
    if (report.degenerate_triangles + report.out_of_range_triangles == 0) return;
    for (Triangle t = 0; t < across_.size(); ++t) {
      if (list.is_triangle(t, vertex_count)) continue;
      alive_[t] = false;
      --triangles_;
    }
  }
  /// Colours the mesh.
  void give(StripMesh& mesh) const { mesh.set_colors(solid_); }

  // As in StripMesh.
  [[nodiscard]] Halfedge opposite(Halfedge h) const noexcept {
    const std::uint32_t there = across(h.id);
    return there == none ? StripMesh::across_boundary(h) : Halfedge{there};
  }
  [[nodiscard]] bool solid(Halfedge h) const noexcept { return !StripMesh::on_boundary(h) && solid(h.id); }
  void set_solid(Halfedge h, bool solid) noexcept {
    if (solid != this->solid(h.id)) flip(h.id);
  }
  [[nodiscard]] unsigned solid_sides(Triangle t) const noexcept { return solid_[t]; }
  [[nodiscard]] unsigned solid_degree(Triangle t) const noexcept {
    return static_cast<unsigned>(std::popcount(solid_[t]));
  }
  [[nodiscard]] unsigned other_solid_sides(Halfedge h) const noexcept { return turn(h.id); }
  [[nodiscard]] StripStep strip_step(Halfedge in) const noexcept {
    const std::uint32_t out = other(in.id);
    if (out == none) return {};
    return {true, {across(out)}};
  }
  [[nodiscard]] bool alive(Triangle t) const noexcept { return alive_[t]; }
  [[nodiscard]] std::size_t triangle_bound() const noexcept { return across_.size(); }
  [[nodiscard]] std::size_t triangle_count() const noexcept { return triangles_; }

  [[nodiscard]] std::size_t strips() const noexcept {
    std::size_t solid_sides = 0;
    for (const std::uint8_t sides : solid_) solid_sides += static_cast<std::size_t>(std::popcount(sides));
    return triangles_ - solid_sides / 2;
  }
  /// A wrong winding counts as a swap. Linear time.
  [[nodiscard]] std::uint64_t cost(const Cost& weights) const noexcept {
    std::uint64_t sum = 0;
    for (Triangle t = 0; t < across_.size(); ++t) {
      if (!alive_[t]) continue;
      if (solid_[t] == 0) sum += std::uint64_t{weights.restart} + weights.isolated;
      for (unsigned s = 0; s < 3; ++s) {
        const std::uint32_t h = t << 2 | s;
        if (solid(h) && h < across(h) && is_swap(h)) sum += weights.swap;
      }
      if (solid_[t] == 0 || full(t)) continue;
      Triangle other_end = t;
      for (std::uint32_t h = only_side(t); h != none; h = other(across(h))) other_end = across(h) >> 2;
      if (other_end < t) continue;
      sum += weights.restart;
      if (begins_wrong(other_end) && begins_wrong(t)) sum += weights.swap;
    }
    return sum;
  }

 protected:
  [[nodiscard]] std::uint32_t across(std::uint32_t h) const noexcept { return across_[h >> 2][h & 3U]; }
  [[nodiscard]] bool solid(std::uint32_t h) const noexcept { return (solid_[h >> 2] >> (h & 3U) & 1U) != 0; }
  [[nodiscard]] bool full(Triangle t) const noexcept { return (0b0110'1000U >> solid_[t] & 1U) != 0; }
  // The lowest solid side; at a strip's end, the only one.
  [[nodiscard]] std::uint32_t only_side(Triangle t) const noexcept {
    return t << 2 | static_cast<std::uint32_t>(std::countr_zero(solid_[t]));
  }
  // The other solid side of the triangle of h, or none.
  [[nodiscard]] std::uint32_t other(std::uint32_t h) const noexcept {
    const auto rest = static_cast<std::uint8_t>(solid_[h >> 2] & ~(1U << (h & 3U)));
    return rest == 0 ? none : (h & ~3U) | static_cast<std::uint32_t>(std::countr_zero(rest));
  }
  // How the strip continues in the triangle of h, seen from h: 0 not at all, 1 over the next side, 2 over the one
  // before.
  [[nodiscard]] unsigned turn(std::uint32_t h) const noexcept {
    return solid_[h >> 2] * 0b1001U >> ((h & 3U) + 1) & 3U;
  }
  // Whether it is a swap (restrip::is_swap). False where a strip ends.
  [[nodiscard]] bool is_swap(std::uint32_t h) const noexcept { return detail::is_swap(turn(h), turn(across(h))) != 0; }

  // Whether the strip that ends at t, written from there, begins with a turn to the right.
  [[nodiscard]] bool begins_wrong(Triangle t) const noexcept {
    return solid_[t] != 0 && turn(across(only_side(t))) == 1;
  }
  void flip(std::uint32_t h) noexcept {
    const std::uint32_t g = across(h);
    solid_[h >> 2] = static_cast<std::uint8_t>(solid_[h >> 2] ^ 1U << (h & 3U));
    solid_[g >> 2] = static_cast<std::uint8_t>(solid_[g >> 2] ^ 1U << (g & 3U));
  }

  std::vector<std::array<std::uint32_t, 3>> across_;  // the opposite halfedge; none on the boundary
  std::vector<bool> alive_;
  std::size_t triangles_ = 0;
  std::vector<std::uint8_t> solid_;  // bit s: side s
};

}  // namespace restrip::detail
