// The hooks of hooks.hpp with linked rules (linked.hpp): strips about twice as long, at two to three times the time of
// the local hooks. They walk the strips around the patch, so no index is needed.
//
//   auto pending = before_collapse_and_link(mesh, chord);
//   library.collapse(...);
//   const auto done = after_collapse_and_link(mesh, std::move(pending), spoke);
//
// hooks.hpp applies, with two differences. First, the first half reads the strips outside the patch, so the second half
// must follow before any other dual edge becomes solid: only one operation is pending at a time. Second, the second
// half links strip ends around the patch and absorbs isolated triangles, so it may set dual edges outside the patch.
// The result is the same as of split_and_link(), collapse_and_link() and flip_and_link().
#pragma once

#include <utility>

#include "restrip/operations/hooks.hpp"
#include "restrip/operations/impl/hooks.hpp"
#include "restrip/operations/linked.hpp"

namespace restrip {

/// The rules that the hooks of an adapter use.
enum class HookRules {
  local,  ///< hooks.hpp
  linked  ///< this file
};

/// See before_split().
template <ColoredMesh Mesh>
[[nodiscard]] PendingSplit<typename Mesh::Halfedge> before_split_and_link(
    Mesh& mesh, const VertexSplit<typename Mesh::Halfedge>& where) {
  return detail::before_split_by(detail::LinkedRules{default_reach}, mesh, where);
}
template <ColoredMesh Mesh>
Rewrite<typename Mesh::Halfedge> after_split_and_link(Mesh& mesh, PendingSplit<typename Mesh::Halfedge> pending,
                                                      typename Mesh::Halfedge chord) {
  return detail::after_split_by(mesh, std::move(pending), chord, [&](const auto& change) {
    return detail::finish_split_and_join(mesh, change, chord, Exchange::yes);
  });
}

/// See before_collapse().
template <ColoredMesh Mesh>
[[nodiscard]] PendingCollapse<typename Mesh::Halfedge> before_collapse_and_link(Mesh& mesh,
                                                                                typename Mesh::Halfedge chord) {
  return detail::before_collapse_by(detail::LinkedRules{default_reach}, mesh, chord);
}
template <ColoredMesh Mesh>
Rewrite<typename Mesh::Halfedge> after_collapse_and_link(Mesh& mesh, PendingCollapse<typename Mesh::Halfedge> pending,
                                                         typename Mesh::Halfedge spoke) {
  return detail::after_collapse_by(mesh, std::move(pending), spoke, [&](const auto& change) {
    return detail::finish_collapse_and_join(mesh, change, spoke, Exchange::yes);
  });
}

/// For use after before_flip(): flips use the rule, and are linked afterwards.
template <ColoredMesh Mesh>
Rewrite<typename Mesh::Halfedge> after_flip_and_link(Mesh& mesh, PendingFlip<typename Mesh::Halfedge> pending,
                                                     typename Mesh::Halfedge h) {
  const auto done = after_flip(mesh, std::move(pending), h);
  return detail::with(done, join_at_edge(mesh, done.halfedge, Exchange::yes));
}

/// The hooks of an adapter, with the given rules.
template <ColoredMesh Mesh>
[[nodiscard]] PendingCollapse<typename Mesh::Halfedge> before_collapse(Mesh& mesh, typename Mesh::Halfedge chord,
                                                                       HookRules rules) {
  return rules == HookRules::linked ? before_collapse_and_link(mesh, chord) : before_collapse(mesh, chord);
}
template <ColoredMesh Mesh>
Rewrite<typename Mesh::Halfedge> after_collapse(Mesh& mesh, PendingCollapse<typename Mesh::Halfedge> pending,
                                                typename Mesh::Halfedge spoke, HookRules rules) {
  return rules == HookRules::linked ? after_collapse_and_link(mesh, std::move(pending), spoke)
                                    : after_collapse(mesh, std::move(pending), spoke);
}

}  // namespace restrip
