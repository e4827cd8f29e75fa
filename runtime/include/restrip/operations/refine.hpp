// split_face, bisect and their inverses: operations with shipped tables, by name.
//
// split() can also insert a vertex into a triangle or an edge, but it recolours the whole fan around a vertex. Here the
// patch consists of only the triangles around the new vertex, so time does not depend on valences. Longest-edge
// bisection of terrains and of finite elements uses these operations.
//
//     split_face   one triangle becomes three         join_faces   and back
//     bisect       the triangles at an edge           merge        and back
//                  become two each
//
// Each is a list of tables (tables/operations/*.json), inside the mesh and on its boundary; `…_at` says which one fits
// and where. docs/tutorials/custom-operation.md shows how to add a custom one.
#pragma once

#include "restrip/operations/apply.hpp"

namespace restrip {

/// A table and the side where it is applied.
struct OperationPlace {
  OperationView table;
  Halfedge where;  ///< {none}: the halfedge is not one of the mesh
};

/// A new vertex in the triangle of h.
[[nodiscard]] OperationPlace split_face_at(const StripMesh& mesh, Halfedge h);
/// `chord` enters a vertex of three triangles, which is removed.
[[nodiscard]] OperationPlace join_faces_at(const StripMesh& mesh, Halfedge chord);
/// A new vertex on the mesh edge of h, interior or on the boundary.
[[nodiscard]] OperationPlace bisect_at(const StripMesh& mesh, Halfedge h);
/// `chord` enters an interior vertex of four triangles, or along the boundary a vertex of two, which is removed; the
/// vertex that `chord` leaves is joined to the one opposite.
[[nodiscard]] OperationPlace merge_at(const StripMesh& mesh, Halfedge chord);

/// The functions of apply.hpp there.
[[nodiscard]] inline Refusal check_apply(const StripMesh& mesh, const OperationPlace& at) {
  return check_apply(mesh, at.table, at.where);
}
inline Checked checked_apply(StripMesh& mesh, const OperationPlace& at) {
  return checked_apply(mesh, at.table, at.where);
}

/// The operations by the rules, if they are granted.
inline Checked split_face(StripMesh& mesh, Halfedge h) { return checked_apply(mesh, split_face_at(mesh, h)); }
inline Checked join_faces(StripMesh& mesh, Halfedge chord) { return checked_apply(mesh, join_faces_at(mesh, chord)); }
inline Checked bisect(StripMesh& mesh, Halfedge h) { return checked_apply(mesh, bisect_at(mesh, h)); }
inline Checked merge(StripMesh& mesh, Halfedge chord) { return checked_apply(mesh, merge_at(mesh, chord)); }

}  // namespace restrip
