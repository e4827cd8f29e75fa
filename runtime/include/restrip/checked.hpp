// split, collapse and flip for operations of unknown origin: checked in every build, refused with a reason.
//
//   if (const auto done = checked_collapse(mesh, chord))
//     use(done.rewrite.strips);
//   else
//     report(describe(done.refusal));
//
// Each asks its check (checks.hpp) and does the operation when it is granted; a refused operation changes nothing. Give
// a StripMesh for the local rules (operations.hpp), or a StripKeeper for those of its policy.
#pragma once

#include "restrip/checks.hpp"
#include "restrip/keeper.hpp"
#include "restrip/operations.hpp"
#include "restrip/strip_mesh.hpp"

namespace restrip {

/// What a checked operation did, or why it did nothing.
struct Checked {
  Refusal refusal = Refusal::granted;
  Rewrite<StripMesh::Halfedge> rewrite{};  ///< of the operation, if it was granted

  [[nodiscard]] constexpr bool granted() const noexcept { return refusal == Refusal::granted; }
  constexpr explicit operator bool() const noexcept { return granted(); }
};

/// `new_vertex`: see check_split. Cost: that of the check and of the operation. May throw what the mesh throws to grow
/// (std::bad_alloc, std::length_error); nothing has changed then.
inline Checked checked_split(StripMesh& mesh, const VertexSplit<StripMesh::Halfedge>& where, Vertex new_vertex = none) {
  if (const Refusal refusal = check_split(mesh, where, new_vertex); refusal != Refusal::granted) return {refusal};
  return {Refusal::granted, split(mesh, where, new_vertex)};
}
inline Checked checked_collapse(StripMesh& mesh, StripMesh::Halfedge chord) {
  if (const Refusal refusal = check_collapse(mesh, chord); refusal != Refusal::granted) return {refusal};
  return {Refusal::granted, collapse(mesh, chord)};
}
inline Checked checked_flip(StripMesh& mesh, StripMesh::Halfedge h) {
  if (const Refusal refusal = check_flip(mesh, h); refusal != Refusal::granted) return {refusal};
  return {Refusal::granted, flip(mesh, h)};
}

/// The same under the policy of a keeper.
inline Checked checked_split(StripKeeper& keeper, const VertexSplit<StripMesh::Halfedge>& where,
                             Vertex new_vertex = none) {
  if (const Refusal refusal = check_split(keeper.mesh(), where, new_vertex); refusal != Refusal::granted)
    return {refusal};
  return {Refusal::granted, keeper.split(where, new_vertex)};
}
inline Checked checked_collapse(StripKeeper& keeper, StripMesh::Halfedge chord) {
  if (const Refusal refusal = check_collapse(keeper.mesh(), chord); refusal != Refusal::granted) return {refusal};
  return {Refusal::granted, keeper.collapse(chord)};
}
inline Checked checked_flip(StripKeeper& keeper, StripMesh::Halfedge h) {
  if (const Refusal refusal = check_flip(keeper.mesh(), h); refusal != Refusal::granted) return {refusal};
  return {Refusal::granted, keeper.flip(h)};
}

}  // namespace restrip
