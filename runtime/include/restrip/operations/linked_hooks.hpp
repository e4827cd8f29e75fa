// hooks.hpp by linked rules (linked.hpp): strips about twice as long kept while another library changes the mesh, at
// two to three times the time of the local hooks. No index is needed, as the strips around the patch are walked.
//
//   auto pending = before_collapse_and_link(mesh, chord);
//   library.collapse(...);
//   const auto done = after_collapse_and_link(mesh, std::move(pending), spoke);
//
// All that hooks.hpp says holds, with two differences. The first half has looked at the strips outside the patch, so
// the second half must follow before any other dual edge becomes solid: one operation is pending at a time. And the
// second half links strip ends around the patch, and adopts, so it may make dual edges solid outside it. The result is
// that of split_and_link(), collapse_and_link() and flip_and_link().
#pragma once

#include <utility>

#include "restrip/operations/hooks.hpp"
#include "restrip/operations/impl/hooks.hpp"
#include "restrip/operations/linked.hpp"

namespace restrip {

/// Which rules the hooks of an adapter follow.
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

/// After before_flip(): flips have no linked rule, and are linked afterwards.
template <ColoredMesh Mesh>
Rewrite<typename Mesh::Halfedge> after_flip_and_link(Mesh& mesh, PendingFlip<typename Mesh::Halfedge> pending,
                                                     typename Mesh::Halfedge h) {
  const auto done = after_flip(mesh, std::move(pending), h);
  return detail::with(done, join_beside(mesh, done.halfedge, Exchange::yes));
}

/// The hooks of an adapter, by the rules named.
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
