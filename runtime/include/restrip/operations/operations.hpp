// split, collapse, flip: the operations of a dynamic mesh, which maintain its strips.
//
// Each reads the colours around the operation, looks up its rule (rules.hpp), lets the mesh change, and writes the new
// colours. Nothing outside the patch is read or written, so operations on disjoint patches commute. The only state is
// the colours. Fans of at most max_word_valence triangles need no allocation. Time is linear in the valence.
//
// Same preconditions as the mesh operation. Debug builds check them first and abort with the reason
// (precondition.hpp). For a StripMesh they check all of checks.hpp. For other meshes they check what a walk around the
// patch finds, and `bool alive(h)` if the mesh has it, then the mesh's own check_split(), check_collapse() and
// check_flip(), if it has them (checked.hpp).
#pragma once

#include <cstdint>

#include "restrip/mesh/mesh.hpp"
#include "restrip/operations/result.hpp"

namespace restrip {

/// Splits a vertex and recolours the patch (VertexSplit describes the new triangles).
template <NamesNewVertices Mesh>
Rewrite<typename Mesh::Halfedge> split(Mesh& mesh, const VertexSplit<typename Mesh::Halfedge>& where);

/// Splits a vertex of a mesh that lets the caller name the new one.
template <SplittableMesh Mesh, class Vertex>
requires requires(Mesh& mesh, VertexSplit<typename Mesh::Halfedge> where, Vertex v) { mesh.insert_vertex(where, v); }
Rewrite<typename Mesh::Halfedge> split(Mesh& mesh, const VertexSplit<typename Mesh::Halfedge>& where,
                                       Vertex new_vertex);

/// Collapses the mesh edge of `chord` = v_s -> v_t into v_s and recolours the patch.
template <CollapsibleMesh Mesh>
Rewrite<typename Mesh::Halfedge> collapse(Mesh& mesh, typename Mesh::Halfedge chord);

/// Flips the interior mesh edge of h and recolours the patch. A port is cleared only if no sound recolouring keeps it.
/// The triangle outside may then be isolated, which Rewrite::isolated counts.
template <FlippableMesh Mesh>
Rewrite<typename Mesh::Halfedge> flip(Mesh& mesh, typename Mesh::Halfedge h);

}  // namespace restrip

#include "restrip/operations/impl/operations.hpp"
