// split_face, bisect and their inverses: operations on two to four triangles that maintain strips.
//
// split() can also insert a vertex into a triangle or an edge, but it recolours the whole fan around a vertex. Here the
// patch consists of only the triangles around the new vertex, so time does not depend on valences (a StripMesh chooses
// the vertex to move, never one with more triangles than the patch). Longest-edge bisection of terrains and of finite
// elements uses these operations. The rules come from operation files, tables/operations/*.json;
// docs/tutorials/custom-operation.md shows how to add a custom one.
//
//     split_face   one triangle becomes three         join_faces   and back
//     bisect       the triangles at an edge           merge        and back
//                  become two each
//
// Nothing outside the patch is read or written, except that the inverses may clear a port, which is also an edge of the
// triangle outside. Preconditions and exceptions are as in operations.hpp: debug builds check the preconditions of the
// mesh operation; exceptions of the mesh leave the colouring valid.
#pragma once

#include "restrip/mesh/checks.hpp"
#include "restrip/mesh/mesh.hpp"
#include "restrip/mesh/strip_mesh.hpp"
#include "restrip/operations/checked.hpp"
#include "restrip/operations/operations.hpp"

namespace restrip {

/// Puts a new vertex v_t into the triangle of h, which leaves v_s. Rewrite::halfedge is v_s -> v_t, its valence 3.
template <NamesNewVertices Mesh>
Rewrite<typename Mesh::Halfedge> split_face(Mesh& mesh, typename Mesh::Halfedge h);

/// Removes v_t, a vertex of three triangles, of `chord` = v_s -> v_t: the inverse of split_face(). Rewrite::halfedge
/// leaves v_s and is a side of the triangle that remains, which lies to the left of its opposite; its valence is 3.
template <CollapsibleMesh Mesh>
Rewrite<typename Mesh::Halfedge> join_faces(Mesh& mesh, typename Mesh::Halfedge chord);

/// Puts a new vertex v_t on the mesh edge of h, interior or on the boundary; h leaves v_s. Rewrite::halfedge is v_s ->
/// v_t, its valence the triangles around v_t: 4, or 2 on the boundary.
template <NamesNewVertices Mesh>
Rewrite<typename Mesh::Halfedge> bisect(Mesh& mesh, typename Mesh::Halfedge h);

/// Removes v_t, an interior vertex of four triangles or a boundary vertex of two, of `chord` = v_s -> v_t, and joins
/// v_s to the vertex opposite: the inverse of bisect(). On the boundary `chord` or its opposite lacks a triangle.
/// Rewrite::halfedge is the mesh edge that replaces two, as it leaves v_s; its valence is 4, or 2.
template <CollapsibleMesh Mesh>
Rewrite<typename Mesh::Halfedge> merge(Mesh& mesh, typename Mesh::Halfedge chord);

// Whether they may be done on a StripMesh, see checks.hpp. A few steps; the inverses as check_collapse().
[[nodiscard]] inline Refusal check_split_face(const StripMesh& mesh, StripMesh::Halfedge h);
[[nodiscard]] inline Refusal check_join_faces(const StripMesh& mesh, StripMesh::Halfedge chord);
[[nodiscard]] inline Refusal check_bisect(const StripMesh& mesh, StripMesh::Halfedge h);
[[nodiscard]] inline Refusal check_merge(const StripMesh& mesh, StripMesh::Halfedge chord);

// On a mesh or a Keeper, for operations from an untrusted source: see checked.hpp.
template <CheckedTarget Target>
detail::CheckedOf<Target> checked_split_face(Target& target, detail::HalfedgeOf<Target> h);
template <CheckedTarget Target>
detail::CheckedOf<Target> checked_join_faces(Target& target, detail::HalfedgeOf<Target> chord);
template <CheckedTarget Target>
detail::CheckedOf<Target> checked_bisect(Target& target, detail::HalfedgeOf<Target> h);
template <CheckedTarget Target>
detail::CheckedOf<Target> checked_merge(Target& target, detail::HalfedgeOf<Target> chord);

}  // namespace restrip

#include "restrip/operations/impl/refine.hpp"
