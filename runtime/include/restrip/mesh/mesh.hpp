// What searches and buffers read of a mesh or of a copy of its colours.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>

#include "restrip/mesh/strip_mesh.hpp"
#include "restrip/mesh/walks.hpp"

namespace restrip {

template <class Mesh>
concept NumberedMesh = requires(const Mesh& mesh, Halfedge h, std::uint32_t t) {
  { mesh.opposite(h) } -> std::same_as<Halfedge>;
  { mesh.solid(h) } -> std::convertible_to<bool>;
  { mesh.triangle(h) } -> std::convertible_to<std::uint32_t>;
  { mesh.halfedge(t) } -> std::same_as<Halfedge>;
  { mesh.has_triangle(t) } -> std::convertible_to<bool>;
  { mesh.triangle_bound() } -> std::convertible_to<std::size_t>;
  { mesh.from(h) } -> std::convertible_to<std::uint32_t>;
};
template <class Mesh>
concept ColoredMesh = requires(const Mesh& mesh, Halfedge h) {
  { mesh.opposite(h) } -> std::same_as<Halfedge>;
  { mesh.solid(h) } -> std::convertible_to<bool>;
};

template <class Mesh>
StripStep strip_step(const Mesh& mesh, Halfedge in) {
  return mesh.strip_step(in);
}

}  // namespace restrip
