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
  static_assert(
      requires(const Mesh& mesh, Halfedge h) {
        { mesh.next(h) } -> std::same_as<Halfedge>;
      },
      "restrip: the mesh has no Halfedge next(Halfedge) const");
  static_assert(
      requires(const Mesh& mesh, Halfedge h) {
        { mesh.opposite(h) } -> std::same_as<Halfedge>;
      },
      "restrip: the mesh has no Halfedge opposite(Halfedge) const");
  static_assert(
      requires(const Mesh& mesh, Halfedge h) {
        { mesh.on_boundary(h) } -> std::convertible_to<bool>;
      },
      "restrip: the mesh has no bool on_boundary(Halfedge) const");
  static_assert(
      requires(const Mesh& mesh, Halfedge h) {
        { mesh.solid(h) } -> std::convertible_to<bool>;
      },
      "restrip: the mesh has no bool solid(Halfedge) const");
  static_assert(
      requires(Mesh & mesh, Halfedge h, bool solid) { mesh.set_solid(h, solid); },
      "restrip: the mesh has no set_solid(Halfedge, bool)");
  static_assert(
      requires(const Mesh& mesh, Halfedge h) {
        { mesh.triangle(h) } -> std::convertible_to<std::uint32_t>;
      },
      "restrip: the mesh has no std::uint32_t triangle(Halfedge) const");
  static_assert(
      requires(const Mesh& mesh, std::uint32_t t) {
        { mesh.halfedge(t) } -> std::same_as<Halfedge>;
      },
      "restrip: the mesh has no Halfedge halfedge(std::uint32_t) const");
  static_assert(
      requires(const Mesh& mesh, std::uint32_t t) {
        { mesh.has_triangle(t) } -> std::convertible_to<bool>;
      },
      "restrip: the mesh has no bool has_triangle(std::uint32_t) const");
  static_assert(
      requires(const Mesh& mesh) {
        { mesh.triangle_bound() } -> std::convertible_to<std::size_t>;
      },
      "restrip: the mesh has no std::size_t triangle_bound() const");
  static_assert(
      requires(const Mesh& mesh, Halfedge h) {
        { mesh.from(h) } -> std::convertible_to<std::uint32_t>;
      },
      "restrip: the mesh has no std::uint32_t from(Halfedge) const");
  return true;
}

}  // namespace restrip::detail
