// split, collapse and flip for operations from an untrusted source: checked in every build, refused with a reason.
//
//   if (const auto done = checked_collapse(mesh, chord))
//     use(done.rewrite.strips);
//   else
//     report(describe(done.refusal));
//
// Each asks its check (mesh/checks.hpp) and does the operation if it is granted; a refused operation changes nothing.
// Pass a StripMesh for the local rules (operations.hpp), or a StripKeeper for those of its policy.
#pragma once

#include <concepts>
#include <utility>

#include "restrip/mesh/checks.hpp"
#include "restrip/mesh/strip_mesh.hpp"
#include "restrip/operations/operations.hpp"

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

/// Something that keeps the strips of a StripMesh in its own way: StripKeeper (search/keeper.hpp), or a class of yours.
template <class Keeper>
concept KeepsStrips = requires(Keeper& keeper, const VertexSplit<StripMesh::Halfedge>& where, StripMesh::Halfedge h) {
  { std::as_const(keeper).mesh() } -> std::convertible_to<const StripMesh&>;
  { keeper.split(where, none) } -> std::same_as<Rewrite<StripMesh::Halfedge>>;
  { keeper.collapse(h) } -> std::same_as<Rewrite<StripMesh::Halfedge>>;
  { keeper.flip(h) } -> std::same_as<Rewrite<StripMesh::Halfedge>>;
};

/// The same by a keeper.
template <KeepsStrips Keeper>
Checked checked_split(Keeper& keeper, const VertexSplit<StripMesh::Halfedge>& where, Vertex new_vertex = none) {
  if (const Refusal refusal = check_split(keeper.mesh(), where, new_vertex); refusal != Refusal::granted)
    return {refusal};
  return {Refusal::granted, keeper.split(where, new_vertex)};
}
template <KeepsStrips Keeper>
Checked checked_collapse(Keeper& keeper, StripMesh::Halfedge chord) {
  if (const Refusal refusal = check_collapse(keeper.mesh(), chord); refusal != Refusal::granted) return {refusal};
  return {Refusal::granted, keeper.collapse(chord)};
}
template <KeepsStrips Keeper>
Checked checked_flip(Keeper& keeper, StripMesh::Halfedge h) {
  if (const Refusal refusal = check_flip(keeper.mesh(), h); refusal != Refusal::granted) return {refusal};
  return {Refusal::granted, keeper.flip(h)};
}

}  // namespace restrip
