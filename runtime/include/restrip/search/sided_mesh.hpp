// The meshes that searches work on: triangles whose three sides have numbers.
//
// A search examines thousands of dual edges around an operation, and keeps them in tables. So it names a dual edge by a
// triangle and a side 0, 1, 2, counter-clockwise, as the pair of numbers StripMesh::Halfedge. A StripMesh is a sided
// mesh. SideView makes one of any other NumberedMesh: side 0 of triangle t is the side of mesh.halfedge(t).
//
// A handle of a view keeps its meaning as long as mesh.halfedge(t) does for its triangle. Searches keep handles only
// during a call; StripLocator keeps handles of triangles next to a patch while the patch is rewritten.
#pragma once

#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <utility>

#include "restrip/mesh/mesh.hpp"
#include "restrip/mesh/strip_mesh.hpp"

namespace restrip {

/// The members that searches call, with the same meaning as in StripMesh.
template <class Mesh>
concept SidedMesh = std::same_as<typename Mesh::Halfedge, StripMesh::Halfedge> &&
    requires(const Mesh& mesh, StripMesh::Halfedge h, Triangle t) {
  { mesh.opposite(h) } -> std::same_as<StripMesh::Halfedge>;
  { mesh.solid(h) } -> std::same_as<bool>;
  { mesh.solid_sides(t) } -> std::same_as<unsigned>;
  { mesh.solid_degree(t) } -> std::same_as<unsigned>;
  { mesh.other_solid_sides(h) } -> std::same_as<unsigned>;
  { mesh.strip_step(h) } -> std::same_as<StripStep>;
  { mesh.alive(t) } -> std::same_as<bool>;
  { mesh.triangle_bound() } -> std::same_as<std::size_t>;
  { mesh.triangle_count() } -> std::same_as<std::size_t>;
};

/// A NumberedMesh by its sides. Refers to the mesh, which must outlive it; cheap to make and to copy. Each function
/// takes a few calls of the mesh, except triangle_count(), clear_colors() and set_colors(), which are linear.
template <class Mesh>
requires NumberedMesh<std::remove_const_t<Mesh>>
class SideView {
 public:
  using Halfedge = StripMesh::Halfedge;

  explicit SideView(Mesh& mesh) noexcept : mesh_(&mesh) {}

  [[nodiscard]] static constexpr Halfedge halfedge(Triangle t, unsigned side = 0) noexcept {
    return StripMesh::halfedge(t, side);
  }
  [[nodiscard]] static constexpr Triangle triangle(Halfedge h) noexcept { return StripMesh::triangle(h); }
  [[nodiscard]] static constexpr bool on_boundary(Halfedge h) noexcept { return StripMesh::on_boundary(h); }
  [[nodiscard]] static constexpr Halfedge next(Halfedge h) noexcept { return StripMesh::next(h); }
  [[nodiscard]] Halfedge opposite(Halfedge h) const {
    if (on_boundary(h)) return StripMesh::across_boundary(h);
    const auto across = mesh_->opposite(own(h));
    return mesh_->on_boundary(across) ? StripMesh::across_boundary(h) : named(across);
  }
  [[nodiscard]] std::uint32_t from(Halfedge h) const {
    return static_cast<std::uint32_t>(on_boundary(h) ? mesh_->from(mesh_->next(own(opposite(h))))
                                                     : mesh_->from(own(h)));
  }

  /// Conversions between sides and handles of the mesh, which must have a triangle.
  [[nodiscard]] typename Mesh::Halfedge own(Halfedge h) const {
    auto side = mesh_->halfedge(triangle(h));
    for (unsigned s = StripMesh::side(h); s > 0; --s) side = mesh_->next(side);
    return side;
  }
  [[nodiscard]] Halfedge named(typename Mesh::Halfedge h) const {
    const auto t = static_cast<Triangle>(mesh_->triangle(h));
    const auto first = mesh_->halfedge(t);
    return halfedge(t, first == h ? 0U : mesh_->next(first) == h ? 1U : 2U);
  }

  [[nodiscard]] bool solid(Halfedge h) const { return !on_boundary(h) && bool{mesh_->solid(own(h))}; }
  void set_solid(Halfedge h, bool solid) { mesh_->set_solid(own(h), solid); }
  [[nodiscard]] unsigned solid_sides(Triangle t) const {
    const auto first = mesh_->halfedge(t);
    const auto second = mesh_->next(first);
    return unsigned{mesh_->solid(first)} | unsigned{mesh_->solid(second)} << 1 |
           unsigned{mesh_->solid(mesh_->next(second))} << 2;
  }
  [[nodiscard]] unsigned solid_degree(Triangle t) const { return static_cast<unsigned>(std::popcount(solid_sides(t))); }
  [[nodiscard]] unsigned other_solid_sides(Halfedge h) const {
    const auto side = mesh_->next(own(h));
    return unsigned{mesh_->solid(side)} | unsigned{mesh_->solid(mesh_->next(side))} << 1;
  }
  /// From side 3, which is not a side, it leaves over the lowest solid side.
  [[nodiscard]] StripStep strip_step(Halfedge in) const {
    Halfedge out = StripMesh::side(in) == 3 ? halfedge(triangle(in), 0) : next(in);
    for (int tries = StripMesh::side(in) == 3 ? 3 : 2; tries > 0; --tries, out = next(out))
      if (solid(out)) return {true, opposite(out)};
    return {};
  }

  [[nodiscard]] bool has_triangle(Triangle t) const { return t < triangle_bound() && bool{mesh_->has_triangle(t)}; }
  [[nodiscard]] bool alive(Triangle t) const { return has_triangle(t); }
  [[nodiscard]] bool alive(Halfedge h) const { return StripMesh::side(h) < 3 && has_triangle(triangle(h)); }
  [[nodiscard]] std::size_t triangle_bound() const { return std::size_t{mesh_->triangle_bound()}; }
  [[nodiscard]] std::size_t triangle_count() const {
    std::size_t count = 0;
    for (Triangle t = 0; t < triangle_bound(); ++t) count += has_triangle(t) ? 1U : 0U;
    return count;
  }
  void clear_colors() {
    color([](Triangle) { return 0U; });
  }
  void set_colors(std::span<const std::uint8_t> solid_sides) {
    color([&](Triangle t) { return unsigned{solid_sides[t]}; });
  }

 private:
  // Clears edges first, so that the colouring stays valid if the old and the new one are.
  template <class Colors>
  void color(Colors&& wanted) {
    for (const bool solid : {false, true})
      for (Triangle t = 0; t < triangle_bound(); ++t) {
        if (!has_triangle(t)) continue;
        const unsigned now = solid_sides(t);
        for (unsigned s = 0; s < 3; ++s)
          if ((now >> s & 1U) != (wanted(t) >> s & 1U) && ((now >> s & 1U) == 0) == solid)
            set_solid(halfedge(t, s), solid);
      }
  }

  Mesh* mesh_;
};

/// The mesh itself if it has sides, else a view of it.
template <class Mesh>
[[nodiscard]] decltype(auto) by_sides(Mesh& mesh) noexcept {
  if constexpr (SidedMesh<std::remove_const_t<Mesh>>)
    return (mesh);
  else
    return SideView<Mesh>(mesh);
}

static_assert(SidedMesh<StripMesh>);

namespace detail {

/// The lowest of some sides of t, bits of a mask that is not 0.
inline StripMesh::Halfedge lowest_side(Triangle t, unsigned sides) noexcept {
  return StripMesh::halfedge(t, static_cast<unsigned>(std::countr_zero(sides)));
}

}  // namespace detail

}  // namespace restrip
