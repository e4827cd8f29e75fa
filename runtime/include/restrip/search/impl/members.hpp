// The first line of an error for a mesh that lacks a member. Included by keeper.hpp.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>

namespace restrip::detail {

/// True, or an error that names a member of NumberedMesh that this mesh lacks.
template <class Mesh>
consteval bool has_members_of_numbered_mesh() {
  static_assert(
      requires { typename Mesh::Halfedge; }, "restrip: the mesh has no type Halfedge");
  using Halfedge = typename Mesh::Halfedge;
  static_assert(std::regular<Halfedge>,
                "restrip: Halfedge of the mesh is not default-constructible, copyable and comparable");
#define RESTRIP_NEEDS(call, type, member)                       \
  static_assert(                                                \
      requires(const Mesh& mesh, Halfedge h, std::uint32_t t) { \
        { call } -> type;                                       \
      },                                                        \
      "restrip: the mesh has no " member)
  RESTRIP_NEEDS(mesh.next(h), std::same_as<Halfedge>, "Halfedge next(Halfedge) const");
  RESTRIP_NEEDS(mesh.opposite(h), std::same_as<Halfedge>, "Halfedge opposite(Halfedge) const");
  RESTRIP_NEEDS(mesh.on_boundary(h), std::convertible_to<bool>, "bool on_boundary(Halfedge) const");
  RESTRIP_NEEDS(mesh.solid(h), std::convertible_to<bool>, "bool solid(Halfedge) const");
  static_assert(
      requires(Mesh & mesh, Halfedge h, bool solid) { mesh.set_solid(h, solid); },
      "restrip: the mesh has no set_solid(Halfedge, bool)");
  RESTRIP_NEEDS(mesh.triangle(h), std::convertible_to<std::uint32_t>, "std::uint32_t triangle(Halfedge) const");
  RESTRIP_NEEDS(mesh.halfedge(t), std::same_as<Halfedge>, "Halfedge halfedge(std::uint32_t) const");
  RESTRIP_NEEDS(mesh.has_triangle(t), std::convertible_to<bool>, "bool has_triangle(std::uint32_t) const");
  RESTRIP_NEEDS(mesh.triangle_bound(), std::convertible_to<std::size_t>, "std::size_t triangle_bound() const");
  RESTRIP_NEEDS(mesh.from(h), std::convertible_to<std::uint32_t>, "std::uint32_t from(Halfedge) const");
#undef RESTRIP_NEEDS
  return true;
}

}  // namespace restrip::detail
