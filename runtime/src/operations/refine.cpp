// split_face, bisect and their inverses: which table fits at a halfedge. First sides are as in
// tables/operations/*.json.
#include "restrip/operations/refine.hpp"

#include "restrip/tables/operations/bisect.hpp"
#include "restrip/tables/operations/bisect_boundary.hpp"
#include "restrip/tables/operations/join_faces.hpp"
#include "restrip/tables/operations/merge.hpp"
#include "restrip/tables/operations/merge_boundary.hpp"
#include "restrip/tables/operations/split_face.hpp"

namespace restrip {

OperationPlace split_face_at(const StripMesh& /*mesh*/, Halfedge h) { return {tables::split_face_rules, h}; }

OperationPlace join_faces_at(const StripMesh& mesh, Halfedge chord) {
  return {tables::join_faces_rules, mesh.alive(chord) ? mesh.opposite(chord) : Halfedge{}};
}

OperationPlace bisect_at(const StripMesh& mesh, Halfedge h) {
  if (!mesh.alive(h)) return {tables::bisect_rules, {}};
  if (StripMesh::on_boundary(h)) return {tables::bisect_boundary_rules, mesh.opposite(h)};
  if (StripMesh::on_boundary(mesh.opposite(h))) return {tables::bisect_boundary_rules, h};
  return {tables::bisect_rules, h};
}

OperationPlace merge_at(const StripMesh& mesh, Halfedge chord) {
  if (!mesh.alive(chord)) return {tables::merge_rules, {}};
  // On the boundary the first triangle is the one whose side on the boundary leaves the vertex that goes.
  if (StripMesh::on_boundary(chord)) return {tables::merge_boundary_rules, mesh.opposite(chord)};
  const Halfedge after = mesh.opposite(StripMesh::next(chord));  // beyond the triangle to the left
  if (StripMesh::on_boundary(mesh.opposite(chord)))
    return {tables::merge_boundary_rules, StripMesh::on_boundary(after) ? after : StripMesh::next(after)};
  // The side opposite the vertex that goes, in the triangle after the one to the left.
  if (StripMesh::on_boundary(after)) return {tables::merge_rules, after};
  return {tables::merge_rules, StripMesh::next(StripMesh::next(after))};
}

}  // namespace restrip
