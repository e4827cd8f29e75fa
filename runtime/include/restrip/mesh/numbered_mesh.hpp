// What index buffers ask of a mesh beyond walking and colours: numbers for its triangles and vertices.
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
// triangle is removed, and may then be given to another one. `halfedge(t)` is the same each time, and stays for
// triangles that an operation does not touch: searches name sides by it.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>

#include "restrip/mesh/mesh.hpp"

namespace restrip {

/// A mesh that numbers its triangles and vertices. `triangle` and `from` are asked for halfedges with a triangle only,
/// `halfedge` for triangles of the mesh only, `has_triangle` for numbers below the bound only.
template <class Mesh>
concept NumberedMesh = ColoredMesh<Mesh> && requires(const Mesh& mesh, typename Mesh::Halfedge h, std::uint32_t t) {
  { mesh.triangle(h) } -> std::convertible_to<std::uint32_t>;
  { mesh.halfedge(t) } -> std::same_as<typename Mesh::Halfedge>;
  { mesh.has_triangle(t) } -> std::convertible_to<bool>;
  { mesh.triangle_bound() } -> std::convertible_to<std::size_t>;
  { mesh.from(h) } -> std::convertible_to<std::uint32_t>;
};

}  // namespace restrip
