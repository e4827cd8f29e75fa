// split, collapse and flip for operations from an untrusted source: checked in every build, and refused with a reason.
//
//   if (const auto done = checked_collapse(mesh, chord))
//     use(done.rewrite.strips);
//   else
//     report(describe(done.refusal));
//
// Each calls its check and does the operation if it is granted; a refused operation changes nothing. Pass a mesh for
// the rules (operations.hpp), or a Keeper for its policy. The checks of a StripMesh are in mesh/checks.hpp. On a custom
// mesh handles are checked if it has alive(), then what a walk around the patch can see, which excludes the link
// condition and flips onto an existing edge, because vertices have no names there. Then its own checks follow, found by
// argument-dependent lookup, also through a Watched:
//
//   restrip::Refusal check_collapse(const Mesh& mesh, Mesh::Halfedge chord);
//   restrip::Refusal check_flip(const Mesh& mesh, Mesh::Halfedge h);
//   restrip::Refusal check_split(const Mesh& mesh, const restrip::VertexSplit<Mesh::Halfedge>& where);
#pragma once

#include <concepts>
#include <type_traits>
#include <utility>

#include "restrip/mesh/checks.hpp"
#include "restrip/mesh/strip_mesh.hpp"
#include "restrip/operations/impl/patch_checks.hpp"
#include "restrip/operations/operations.hpp"
#include "restrip/operations/result.hpp"

namespace restrip {

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
template <class Target>
using HalfedgeOf = typename MeshOf<Target>::Halfedge;
template <class Target>
inline constexpr bool on_strip_mesh = std::derived_from<MeshOf<Target>, StripMesh>;
template <class Target>
using CheckedOf = std::conditional_t<on_strip_mesh<Target>, Checked, CustomChecked<HalfedgeOf<Target>>>;

/// Does the operation if its check grants it: on_mesh(mesh) or on_keeper(keeper), whichever the target is.
template <class Target, class OnMesh, class OnKeeper>
CheckedOf<Target> done_if_granted(Target& target, Refusal refusal, const OnMesh& on_mesh, const OnKeeper& on_keeper) {
  CheckedOf<Target> done;
  done.refusal = refusal;
  if (!done) return done;
  if constexpr (ColoredMesh<Target>)
    done.rewrite = on_mesh(target);
  else
    done.rewrite = on_keeper(target);
  return done;
}
template <class Target, class... Name>
auto split_if_granted(Target& target, const VertexSplit<HalfedgeOf<Target>>& where, const Name&... name) {
  return done_if_granted(
      target, refusal_of_split(mesh_of(target), where, name...),
      [&](auto& mesh) { return split(mesh, where, name...); },
      [&](auto& keeper) { return keeper.split(where, name...); });
}
/// The result of an operation that adds a vertex, to which the halfedge of its Rewrite leads.
template <class Target, class Done>
Done with_vertex(const Target& target, Done done) {
  if constexpr (on_strip_mesh<Target>)
    if (done) done.new_vertex = mesh_of(target).to(done.rewrite.halfedge);
  return done;
}

}  // namespace detail

/// A mesh, or a class that maintains the strips of one: Keeper (search/keeper.hpp), or a custom one with the same
/// operations.
template <class Target>
concept CheckedTarget = ColoredMesh<Target> ||
    (requires(const Target& target) { target.mesh(); } && ColoredMesh<detail::MeshOf<Target>>);

/// `new_vertex`: see check_split. Takes the time of the check and of the operation. May throw what the mesh throws when
/// it grows (std::bad_alloc, std::length_error); nothing has changed then.
template <CheckedTarget Target>
requires detail::on_strip_mesh<Target> Checked checked_split(Target& target,
                                                             const VertexSplit<StripMesh::Halfedge>& where,
                                                             Vertex new_vertex = none) {
  return detail::with_vertex(target, detail::split_if_granted(target, where, new_vertex));
}
/// On a custom mesh. `name`: the new vertex, if the mesh takes one.
template <CheckedTarget Target, class... Name>
requires(!detail::on_strip_mesh<Target>) auto checked_split(Target& target,
                                                            const VertexSplit<detail::HalfedgeOf<Target>>& where,
                                                            const Name&... name) {
  return detail::split_if_granted(target, where, name...);
}
template <CheckedTarget Target>
auto checked_collapse(Target& target, detail::HalfedgeOf<Target> chord) {
  return detail::done_if_granted(
      target, detail::refusal_of_collapse(detail::mesh_of(target), chord),
      [&](auto& mesh) { return collapse(mesh, chord); }, [&](auto& keeper) { return keeper.collapse(chord); });
}
template <CheckedTarget Target>
auto checked_flip(Target& target, detail::HalfedgeOf<Target> h) {
  return detail::done_if_granted(
      target, detail::refusal_of_flip(detail::mesh_of(target), h), [&](auto& mesh) { return flip(mesh, h); },
      [&](auto& keeper) { return keeper.flip(h); });
}

}  // namespace restrip
