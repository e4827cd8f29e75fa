// split, collapse, flip: the operations of a dynamic mesh, with its strips kept.
//
// Each reads the colours around the operation, looks its rule up (rules.hpp), lets the mesh do the change, and writes
// the colours after. Nothing outside the patch is read or written, so operations on disjoint patches commute. No state
// but the colours, no allocation for fans of at most max_word_valence triangles; time linear in the valence.
//
// Preconditions are those of the mesh operation itself. Debug builds check them first and abort with the reason
// (precondition.hpp): for a StripMesh all of checks.hpp, for other meshes what a walk around the patch tells, and
// `bool alive(h)` where the mesh has it, or its own check_split(mesh, where), check_collapse(mesh, chord) and
// check_flip(mesh, h), which return a Refusal, where it has those.
#pragma once

#include <cstdint>

#include "restrip/mesh/mesh.hpp"

namespace restrip {

/// What an operation did. (Baked operations count strips alone, see baked.hpp.)
template <class Halfedge>
struct Rewrite {
  Halfedge halfedge{};  ///< split: the chord v_s -> v_t; collapse: a spoke of v_s (see CollapsibleMesh); flip: the
                        ///< turned edge
  std::uint32_t valence = 0;  ///< k of the fan that was split or that the collapse left; 4 for a flip
  int strips = 0;             ///< change in the number of strips
  int isolated = 0;           ///< change in the number of isolated triangles of the whole mesh
};

/// Splits a vertex and recolours the patch (see VertexSplit for what goes where).
template <SplittableMesh Mesh>
Rewrite<typename Mesh::Halfedge> split(Mesh& mesh, const VertexSplit<typename Mesh::Halfedge>& where);

/// The same, for meshes that let the caller name the new vertex.
template <SplittableMesh Mesh, class Vertex>
requires requires(Mesh& mesh, VertexSplit<typename Mesh::Halfedge> where, Vertex v) { mesh.insert_vertex(where, v); }
Rewrite<typename Mesh::Halfedge> split(Mesh& mesh, const VertexSplit<typename Mesh::Halfedge>& where,
                                       Vertex new_vertex);

/// Collapses the mesh edge of `chord` = v_s -> v_t into v_s and recolours the patch.
template <CollapsibleMesh Mesh>
Rewrite<typename Mesh::Halfedge> collapse(Mesh& mesh, typename Mesh::Halfedge chord);

/// Flips the interior mesh edge of h and recolours the patch; a port is given up only where no sound recolouring keeps
/// it, and then the triangle behind it may be left isolated, which Rewrite::isolated counts.
template <FlippableMesh Mesh>
Rewrite<typename Mesh::Halfedge> flip(Mesh& mesh, typename Mesh::Halfedge h);

}  // namespace restrip

#include "restrip/operations/impl/operations.hpp"
