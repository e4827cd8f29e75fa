// Split, collapse and flip: the first half, the change of the mesh, the second half. Included by operations.hpp.
#pragma once

#include "restrip/operations/impl/halves.hpp"
#include "restrip/operations/impl/patch_checks.hpp"
#include "restrip/operations/operations.hpp"
#include "restrip/precondition.hpp"

namespace restrip {
namespace detail {

// Passes the walk already done to meshes that can use it, so that they need not turn around the vertex again.
template <class Mesh, class... Name>
typename Mesh::Halfedge change_by_split(Mesh& mesh, const VertexSplit<typename Mesh::Halfedge>& where,
                                        const FanChange<typename Mesh::Halfedge>& change, Name... name) {
  if constexpr (requires { mesh.insert_vertex(where.left, where.right, change.moved(), name...); })
    if (change.interior) return mesh.insert_vertex(where.left, where.right, change.moved(), name...);
  return mesh.insert_vertex(where, name...);
}

template <class Mesh>
typename Mesh::Halfedge change_by_collapse(Mesh& mesh, typename Mesh::Halfedge chord,
                                           const FanChange<typename Mesh::Halfedge>& change) {
  if constexpr (requires { mesh.remove_vertex(chord, change.moved()); })
    if (change.interior) return mesh.remove_vertex(chord, change.moved());
  return mesh.remove_vertex(chord);
}

/// `name`: the new vertex, for meshes that let the caller name it; else nothing.
template <class Mesh, class... Name>
Rewrite<typename Mesh::Halfedge> split_by_rule(Mesh& mesh, const VertexSplit<typename Mesh::Halfedge>& where,
                                               Name... name) {
  const auto change = begin_split(LocalRules{}, mesh, where);
  return finish_split(mesh, change, change_by_split(mesh, where, change, name...));
}

}  // namespace detail

template <NamesNewVertices Mesh>
Rewrite<typename Mesh::Halfedge> split(Mesh& mesh, const VertexSplit<typename Mesh::Halfedge>& where) {
  RESTRIP_ASSERT_GRANTED(detail::refusal_of_split(mesh, where), "split");
  return detail::split_by_rule(mesh, where);
}

template <SplittableMesh Mesh, class Vertex>
requires requires(Mesh& mesh, VertexSplit<typename Mesh::Halfedge> where, Vertex v) { mesh.insert_vertex(where, v); }
Rewrite<typename Mesh::Halfedge> split(Mesh& mesh, const VertexSplit<typename Mesh::Halfedge>& where,
                                       Vertex new_vertex) {
  RESTRIP_ASSERT_GRANTED(detail::refusal_of_split(mesh, where, new_vertex), "split");
  return detail::split_by_rule(mesh, where, new_vertex);
}

template <CollapsibleMesh Mesh>
Rewrite<typename Mesh::Halfedge> collapse(Mesh& mesh, typename Mesh::Halfedge chord) {
  RESTRIP_ASSERT_GRANTED(detail::refusal_of_collapse(mesh, chord), "collapse");
  const auto change = detail::begin_collapse(detail::LocalRules{}, mesh, chord);
  return detail::finish_collapse(mesh, change, detail::change_by_collapse(mesh, chord, change));
}

template <FlippableMesh Mesh>
Rewrite<typename Mesh::Halfedge> flip(Mesh& mesh, typename Mesh::Halfedge h) {
  RESTRIP_ASSERT_GRANTED(detail::refusal_of_flip(mesh, h), "flip");
  const auto change = detail::begin_flip(mesh, h);
  return detail::finish_flip(mesh, change, mesh.turn_edge(h));
}

}  // namespace restrip
