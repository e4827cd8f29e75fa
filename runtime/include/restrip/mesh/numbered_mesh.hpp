// The numbers of triangles and vertices that index buffers need in addition to mesh.hpp.
//
// | function | answers | StripMesh | a custom mesh |
// | --- | --- | --- | --- |
// | `triangle(h)` | the number of the triangle of h | has it | the face index of h |
// | `halfedge(t)` | a halfedge of triangle t | has it (side 0) | the first halfedge of the face |
// | `has_triangle(t)` | is t a triangle of the mesh now? | has it | not deleted |
// | `triangle_bound()` | triangle numbers are below it | has it | the number of face slots |
// | `from(h)` | the number of the vertex that h leaves, as the index buffer names it | has it | the vertex index |
//
// Numbers should be dense: memory is taken for every number below the bound. A number keeps its meaning until its
// triangle is removed, and may then be reused. `halfedge(t)` returns the same halfedge each time, and an operation does
// not change it for triangles that it does not touch: searches name sides by it.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>

#include "restrip/mesh/mesh.hpp"

namespace restrip {

/// A mesh that numbers its triangles and vertices. `triangle` and `from` are called only for halfedges with a triangle,
/// `halfedge` only for triangles of the mesh, `has_triangle` only for numbers below the bound.
template <class Mesh>
concept NumberedMesh = ColoredMesh<Mesh> && requires(const Mesh& mesh, typename Mesh::Halfedge h, std::uint32_t t) {
  { mesh.triangle(h) } -> std::convertible_to<std::uint32_t>;
  { mesh.halfedge(t) } -> std::same_as<typename Mesh::Halfedge>;
  { mesh.has_triangle(t) } -> std::convertible_to<bool>;
  { mesh.triangle_bound() } -> std::convertible_to<std::size_t>;
  { mesh.from(h) } -> std::convertible_to<std::uint32_t>;
};

}  // namespace restrip
