// Why an operation is refused: the answer of the checks (checks.hpp), and the sentence with which a debug build aborts
// (precondition.hpp).
#pragma once

#include "restrip/precondition.hpp"

/// The precondition that a check grants an operation.
#define RESTRIP_ASSERT_GRANTED(refusal, function) \
  RESTRIP_ASSERT((refusal) == ::restrip::Refusal::granted, function, ::restrip::describe(refusal))

namespace restrip {

/// Why an operation is refused.
enum class Refusal {
  granted,              ///< it may be done
  no_such_edge,         ///< the halfedge is not one of the mesh
  different_vertices,   ///< the two spokes of a split do not leave the same vertex
  same_spoke,           ///< the two spokes of a split are the same
  non_manifold_vertex,  ///< the mesh is not manifold at a vertex of the operation
                        ///< (BuildReport::non_manifold_vertices)
  boundary_edge,        ///< a flip needs a triangle on both sides
  spoke_on_boundary,    ///< a one-sided split needs a boundary vertex
  joins_boundaries,  ///< the edge is interior, but both its ends are on the boundary: the collapse would pinch the mesh
  link_condition,    ///< the ends of the edge have a common neighbour besides the apexes: the collapse would fold the
                     ///< mesh
  too_few_triangles,  ///< a closed fan of fewer than three triangles would remain
  dangling_edge,      ///< a triangle to be removed has its only neighbour across the collapsed edge
  edge_exists,        ///< an edge that the operation would make is in the mesh already
  vertex_in_use,      ///< the vertex named for a split has triangles already
  vertex_too_far,     ///< the vertex named for a split is far beyond all others (StripMesh::max_vertex_gap)
  no_manifold,  ///< the triangles around a vertex would be more than one fan, or an edge would have two triangles of
                ///< the same direction
  other_patch,  ///< the triangles there are not the ones that the operation removes, or not the ones that it makes
  same_vertex,  ///< two vertices of the operation are one vertex of the mesh
  colors_not_valid  ///< an operation with a table: a triangle of the patch has three solid edges
};

/// One human-readable sentence.
[[nodiscard]] constexpr const char* describe(Refusal refusal) noexcept {
  switch (refusal) {
    case Refusal::granted:
      return "the operation is possible";
    case Refusal::no_such_edge:
      return "the halfedge is not one of this mesh";
    case Refusal::different_vertices:
      return "the two spokes do not leave the same vertex";
    case Refusal::same_spoke:
      return "the two spokes are the same";
    case Refusal::non_manifold_vertex:
      return "the mesh is not a manifold at one of the vertices";
    case Refusal::boundary_edge:
      return "the edge lies on the boundary";
    case Refusal::spoke_on_boundary:
      return "a split with one spoke needs a vertex on the boundary";
    case Refusal::joins_boundaries:
      return "an interior edge between two boundary vertices: collapsing it would pinch the mesh";
    case Refusal::link_condition:
      return "the ends of the edge have another common neighbour: collapsing it would fold the mesh";
    case Refusal::too_few_triangles:
      return "fewer than three triangles would remain around a vertex";
    case Refusal::dangling_edge:
      return "a triangle at the edge has no other neighbour: collapsing it would leave a dangling edge";
    case Refusal::edge_exists:
      return "an edge that the operation would make exists already";
    case Refusal::vertex_in_use:
      return "the vertex named for the split is already in use";
    case Refusal::vertex_too_far:
      return "the vertex named for the split is so far beyond the vertices of the mesh that the gap would fill the "
             "memory: build the mesh with its final number of vertices";
    case Refusal::no_manifold:
      return "the mesh would not be a manifold at one of the vertices: its triangles would not be one fan";
    case Refusal::other_patch:
      return "the triangles there are not the ones that the operation names";
    case Refusal::same_vertex:
      return "two vertices of the operation are one vertex of the mesh";
    case Refusal::colors_not_valid:
      return "the colours here do not belong to a valid colouring: was the mesh changed without restrip?";
  }
  return "unknown";
}

}  // namespace restrip
