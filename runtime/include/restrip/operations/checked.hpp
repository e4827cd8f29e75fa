// split, collapse and flip for operations from an untrusted source: checked in every build, and refused with a reason.
//
//   if (const auto done = checked_collapse(mesh, chord))
//     use(done.rewrite.strips);
//   else
//     report(describe(done.refusal));
//
// Each calls its check (mesh/checks.hpp) and does the operation if it is granted; a refused operation changes nothing.
// Pass a StripMesh for the rules (operations.hpp), or a Keeper for its policy. A custom mesh and its Keeper have the
// same functions, checked as CustomTarget says.
#pragma once

#include <concepts>
#include <type_traits>
#include <utility>

#include "restrip/mesh/checks.hpp"
#include "restrip/mesh/strip_mesh.hpp"
#include "restrip/operations/impl/patch_checks.hpp"
#include "restrip/operations/operations.hpp"

namespace restrip {

/// The result of a checked operation, or the reason why it was refused.
struct Checked {
  Refusal refusal = Refusal::granted;
  Rewrite<StripMesh::Halfedge> rewrite{};  ///< of the operation, if it was granted
  Vertex new_vertex = none;                ///< of a split, split_face or bisect, if it was granted

  [[nodiscard]] constexpr bool granted() const noexcept { return refusal == Refusal::granted; }
  constexpr explicit operator bool() const noexcept { return granted(); }
};

namespace detail {

/// Does the operation if its check grants it.
template <class Operation>
Checked done_if_granted(Refusal refusal, Operation&& operation) {
  if (refusal != Refusal::granted) return {refusal};
  return {Refusal::granted, operation()};
}
/// The same for an operation that adds a vertex, to which the halfedge of its Rewrite leads.
template <class Operation>
Checked vertex_if_granted(Refusal refusal, const StripMesh& mesh, Operation&& operation) {
  Checked done = done_if_granted(refusal, operation);
  if (done) done.new_vertex = mesh.to(done.rewrite.halfedge);
  return done;
}

}  // namespace detail

/// `new_vertex`: see check_split. Takes the time of the check and of the operation. May throw what the mesh throws when
/// it grows (std::bad_alloc, std::length_error); nothing has changed then.
inline Checked checked_split(StripMesh& mesh, const VertexSplit<StripMesh::Halfedge>& where, Vertex new_vertex = none) {
  return detail::vertex_if_granted(check_split(mesh, where, new_vertex), mesh,
                                   [&] { return split(mesh, where, new_vertex); });
}
inline Checked checked_collapse(StripMesh& mesh, StripMesh::Halfedge chord) {
  return detail::done_if_granted(check_collapse(mesh, chord), [&] { return collapse(mesh, chord); });
}
inline Checked checked_flip(StripMesh& mesh, StripMesh::Halfedge h) {
  return detail::done_if_granted(check_flip(mesh, h), [&] { return flip(mesh, h); });
}

/// A class that maintains the strips of a StripMesh: Keeper (search/keeper.hpp), or a custom one.
template <class Keeper>
concept KeepsStrips = requires(Keeper& keeper, const VertexSplit<StripMesh::Halfedge>& where, StripMesh::Halfedge h) {
  { std::as_const(keeper).mesh() } -> std::convertible_to<const StripMesh&>;
  { keeper.split(where, none) } -> std::same_as<Rewrite<StripMesh::Halfedge>>;
  { keeper.collapse(h) } -> std::same_as<Rewrite<StripMesh::Halfedge>>;
  { keeper.flip(h) } -> std::same_as<Rewrite<StripMesh::Halfedge>>;
};

/// The operations of a keeper, checked in the same way.
template <KeepsStrips Keeper>
Checked checked_split(Keeper& keeper, const VertexSplit<StripMesh::Halfedge>& where, Vertex new_vertex = none) {
  return detail::vertex_if_granted(check_split(keeper.mesh(), where, new_vertex), keeper.mesh(),
                                   [&] { return keeper.split(where, new_vertex); });
}
template <KeepsStrips Keeper>
Checked checked_collapse(Keeper& keeper, StripMesh::Halfedge chord) {
  return detail::done_if_granted(check_collapse(keeper.mesh(), chord), [&] { return keeper.collapse(chord); });
}
template <KeepsStrips Keeper>
Checked checked_flip(Keeper& keeper, StripMesh::Halfedge h) {
  return detail::done_if_granted(check_flip(keeper.mesh(), h), [&] { return keeper.flip(h); });
}

/// What a checked operation did on a custom mesh, or why it did nothing. The halfedge of the rewrite leads to a new
/// vertex.
template <class Halfedge>
struct CustomChecked {
  Refusal refusal = Refusal::granted;
  Rewrite<Halfedge> rewrite{};

  [[nodiscard]] constexpr bool granted() const noexcept { return refusal == Refusal::granted; }
  constexpr explicit operator bool() const noexcept { return granted(); }
};

namespace detail {

/// The mesh of a keeper, or the mesh itself.
template <class Target>
const auto& mesh_of(const Target& target) {
  if constexpr (ColoredMesh<Target>)
    return target;
  else
    return target.mesh();
}
template <class Target>
using MeshOf = std::remove_cvref_t<decltype(mesh_of(std::declval<const Target&>()))>;

}  // namespace detail

/// A custom mesh, or a Keeper of one. Its handles are checked if it has alive(). The check is its own check_split(),
/// check_collapse() or check_flip(), found by argument-dependent lookup. Without these it is what a walk around the
/// patch can see, which excludes the link condition and flips onto an existing edge: vertices have no names there.
template <class Target>
concept CustomTarget = (ColoredMesh<Target> || requires(const Target& target) { target.mesh(); }) &&
                       ColoredMesh<detail::MeshOf<Target>> && !std::derived_from<detail::MeshOf<Target>, StripMesh>;

namespace detail {

template <CustomTarget Target>
using HalfedgeOf = typename MeshOf<Target>::Halfedge;
/// Calls on_mesh(mesh) or on_keeper(keeper), whichever the target is.
template <CustomTarget Target, class OnMesh, class OnKeeper>
CustomChecked<HalfedgeOf<Target>> custom_if_granted(Target& target, Refusal refusal, OnMesh&& on_mesh,
                                                    OnKeeper&& on_keeper) {
  if (refusal != Refusal::granted) return {refusal};
  if constexpr (ColoredMesh<Target>)
    return {Refusal::granted, on_mesh(target)};
  else
    return {Refusal::granted, on_keeper(target)};
}

}  // namespace detail

/// `name`: the new vertex, if the mesh takes one.
template <CustomTarget Target, class... Name>
auto checked_split(Target& target, const VertexSplit<detail::HalfedgeOf<Target>>& where, const Name&... name) {
  return detail::custom_if_granted(
      target, detail::refusal_of_split(detail::mesh_of(target), where, name...),
      [&](auto& mesh) { return split(mesh, where, name...); },
      [&](auto& keeper) { return keeper.split(where, name...); });
}
template <CustomTarget Target>
auto checked_collapse(Target& target, detail::HalfedgeOf<Target> chord) {
  return detail::custom_if_granted(
      target, detail::refusal_of_collapse(detail::mesh_of(target), chord),
      [&](auto& mesh) { return collapse(mesh, chord); }, [&](auto& keeper) { return keeper.collapse(chord); });
}
template <CustomTarget Target>
auto checked_flip(Target& target, detail::HalfedgeOf<Target> h) {
  return detail::custom_if_granted(
      target, detail::refusal_of_flip(detail::mesh_of(target), h), [&](auto& mesh) { return flip(mesh, h); },
      [&](auto& keeper) { return keeper.flip(h); });
}

}  // namespace restrip
