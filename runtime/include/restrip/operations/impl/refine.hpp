// Included by refine.hpp. Ports and edges are numbered as in tables/operations/*.json.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "restrip/operations/impl/operations.hpp"
#include "restrip/operations/impl/patch_checks.hpp"
#include "restrip/operations/refine.hpp"
#include "restrip/precondition.hpp"
#include "restrip/tables/operations/bisect.hpp"
#include "restrip/tables/operations/bisect_boundary.hpp"
#include "restrip/tables/operations/join_faces.hpp"
#include "restrip/tables/operations/merge.hpp"
#include "restrip/tables/operations/merge_boundary.hpp"
#include "restrip/tables/operations/split_face.hpp"

namespace restrip {
namespace detail {

/// Halfedges of a few triangles: for each inner dual edge one of its two, for each port that of the patch, and one of
/// each triangle.
template <class Halfedge, std::size_t Edges, std::size_t Ports, std::size_t Triangles>
struct SmallPatch {
  std::array<Halfedge, Edges> edges{};
  std::array<Halfedge, Ports> ports{};
  std::array<Halfedge, Triangles> triangles{};
};

template <class Halfedge>
using OneFace = SmallPatch<Halfedge, 0, 3, 1>;
template <class Halfedge>
using ThreeFaces = SmallPatch<Halfedge, 3, 3, 3>;
template <class Halfedge>
using TwoBesideEdge = SmallPatch<Halfedge, 1, 4, 2>;
template <class Halfedge>
using FourAroundVertex = SmallPatch<Halfedge, 4, 4, 4>;
template <class Halfedge>
using OneOnBoundary = SmallPatch<Halfedge, 0, 2, 1>;
template <class Halfedge>
using TwoOnBoundary = SmallPatch<Halfedge, 1, 2, 2>;

template <class Mesh, class Halfedge = typename Mesh::Halfedge>
OneFace<Halfedge> one_face(const Mesh& mesh, Halfedge h) {
  return {{}, {h, mesh.next(h), mesh.next(mesh.next(h))}, {h}};
}

/// Around v_t of the chord v_s -> v_t.
template <class Mesh, class Halfedge = typename Mesh::Halfedge>
ThreeFaces<Halfedge> three_faces(const Mesh& mesh, Halfedge chord) {
  const Halfedge up = mesh.next(chord);
  const Halfedge right = mesh.next(mesh.opposite(chord));
  const Halfedge down = mesh.next(right);
  const Halfedge far = mesh.next(mesh.opposite(down));
  return {{down, up, chord}, {right, far, mesh.next(up)}, {right, far, up}};
}

template <class Mesh, class Halfedge = typename Mesh::Halfedge>
TwoBesideEdge<Halfedge> two_beside_edge(const Mesh& mesh, Halfedge h) {
  const Halfedge left = mesh.next(h);
  const Halfedge right = mesh.next(mesh.opposite(h));
  return {{h}, {left, mesh.next(left), right, mesh.next(right)}, {left, right}};
}

template <class Mesh, class Halfedge = typename Mesh::Halfedge>
FourAroundVertex<Halfedge> four_around_vertex(const Mesh& mesh, Halfedge chord) {
  const Halfedge up = mesh.next(chord);
  const Halfedge right = mesh.next(mesh.opposite(chord));
  const Halfedge down = mesh.next(right);
  const Halfedge far = mesh.next(mesh.opposite(up));
  const Halfedge far_right = mesh.next(mesh.opposite(down));
  return {{up, chord, down, far}, {mesh.next(far), mesh.next(up), right, far_right}, {far, up, right, far_right}};
}

/// The triangle of a halfedge on the boundary of the mesh.
template <class Mesh, class Halfedge = typename Mesh::Halfedge>
OneOnBoundary<Halfedge> one_on_boundary(const Mesh& mesh, Halfedge h) {
  return {{}, {mesh.next(h), mesh.next(mesh.next(h))}, {h}};
}

/// The two triangles at v_t, where `chord` v_s -> v_t and its opposite are on the boundary of the mesh, one of them.
template <class Mesh, class Halfedge = typename Mesh::Halfedge>
TwoOnBoundary<Halfedge> two_on_boundary(const Mesh& mesh, Halfedge chord) {
  if (!mesh.on_boundary(chord)) {
    const Halfedge up = mesh.next(chord);
    const Halfedge far = mesh.next(mesh.opposite(up));
    return {{up}, {mesh.next(far), mesh.next(up)}, {far, up}};
  }
  const Halfedge right = mesh.next(mesh.opposite(chord));
  const Halfedge down = mesh.next(right);
  const Halfedge far = mesh.next(mesh.opposite(down));
  return {{down}, {far, right}, {far, right}};
}

template <class Mesh, std::size_t N>
std::uint32_t solid_mask(const Mesh& mesh, const std::array<typename Mesh::Halfedge, N>& halfedges) {
  std::uint32_t mask = 0;
  for (std::size_t i = 0; i < N; ++i) mask |= std::uint32_t{mesh.solid(halfedges[i])} << i;
  return mask;
}

template <class Mesh, std::size_t N>
int isolated_among(const Mesh& mesh, const std::array<typename Mesh::Halfedge, N>& triangles) {
  int isolated = 0;
  for (const auto h : triangles)
    isolated += mesh.solid(h) || mesh.solid(mesh.next(h)) || mesh.solid(mesh.next(mesh.next(h))) ? 0 : 1;
  return isolated;
}

/// Gives the halfedges these colours, and touches no other: all that are to be dashed first.
template <class Mesh, std::size_t Edges, std::size_t Ports, std::size_t Triangles>
void color_patch(Mesh& mesh, const SmallPatch<typename Mesh::Halfedge, Edges, Ports, Triangles>& patch,
                 const tables::OperationRule& rule) {
  for (const bool solid : {false, true}) {
    for (std::size_t i = 0; i < Edges; ++i)
      if ((rule.colors >> i & 1U) == std::uint32_t{solid} && mesh.solid(patch.edges[i]) != solid)
        mesh.set_solid(patch.edges[i], solid);
    for (std::size_t i = 0; i < Ports; ++i)
      if ((rule.ports >> i & 1U) == std::uint32_t{solid} && mesh.solid(patch.ports[i]) != solid)
        mesh.set_solid(patch.ports[i], solid);
  }
}

/// Dashes the ports that the rule gives up; the isolated triangles that this leaves behind them.
template <class Mesh, class Halfedge, std::size_t Ports>
int give_ports_up(Mesh& mesh, const std::array<Halfedge, Ports>& ports, std::uint32_t given_up) {
  std::array<Halfedge, Ports> outer;  // not {}: a handle's default constructor may be explicit
  std::size_t n = 0;
  for (std::size_t i = 0; i < Ports; ++i)
    if ((given_up >> i & 1U) != 0) outer[n++] = mesh.opposite(ports[i]);
  const int isolated = isolated_behind(mesh, std::span<const Halfedge>(outer.data(), n));
  for (std::size_t i = 0; i < n; ++i) mesh.set_solid(outer[i], false);
  return isolated;
}

/// Reads the patch, asks the table, changes the mesh and colours the patch that change() returns; tells the change in
/// strips and isolated triangles.
template <class Mesh, class Table, std::size_t Edges, std::size_t Ports, std::size_t Triangles, class Change>
Rewrite<typename Mesh::Halfedge> rewrite_patch(
    Mesh& mesh, const Table& table, const SmallPatch<typename Mesh::Halfedge, Edges, Ports, Triangles>& before,
    Change&& change) {
  const std::uint32_t ports = solid_mask(mesh, before.ports);
  const tables::OperationRule rule = tables::rule_of(table, solid_mask(mesh, before.edges), ports);
  const int isolated_before = isolated_among(mesh, before.triangles);
  const int isolated_behind = give_ports_up(mesh, before.ports, ports & ~rule.ports);
  const auto [halfedge, after] = change();
  color_patch(mesh, after, rule);
  return {halfedge, static_cast<std::uint32_t>(Ports), rule.strips,
          isolated_among(mesh, after.triangles) - isolated_before + isolated_behind};
}

template <class Mesh, class Halfedge = typename Mesh::Halfedge>
VertexSplit<Halfedge> split_into_face(const Mesh& mesh, Halfedge h) {
  return {mesh.opposite(mesh.next(mesh.next(h))), h};
}

template <class Mesh, class Halfedge = typename Mesh::Halfedge>
VertexSplit<Halfedge> split_on_edge(const Mesh& mesh, Halfedge h) {
  using Spokes = typename VertexSplit<Halfedge>::Spokes;
  if (mesh.on_boundary(h)) return {Halfedge(), mesh.next(mesh.opposite(h)), Spokes::right_only};
  const Halfedge left = mesh.opposite(mesh.next(mesh.next(h)));
  if (mesh.on_boundary(mesh.opposite(h))) return {left, Halfedge(), Spokes::left_only};
  return {left, mesh.next(mesh.opposite(h))};
}

/// Does v_t of the chord v_s -> v_t have this many triangles, if it is interior, and at most so many otherwise?
template <class Mesh, class Halfedge = typename Mesh::Halfedge>
bool head_has(const Mesh& mesh, Halfedge chord, std::size_t interior, std::size_t boundary) {
  const Halfedge first = mesh.opposite(chord);
  Halfedge h = first;
  for (std::size_t n = 0; n <= interior; ++n) {
    if (mesh.on_boundary(h)) break;
    h = turn_ccw(mesh, h);
    if (h == first) return n + 1 == interior;
  }
  if (boundary == 0 || !mesh.on_boundary(h)) return false;
  const Halfedge last = h;
  for (std::size_t n = 0; n <= boundary; ++n) {
    if (mesh.on_boundary(mesh.opposite(h))) return n == boundary && (last == first || h == first);
    h = turn_cw(mesh, h);
  }
  return false;
}

template <class Mesh, class Halfedge = typename Mesh::Halfedge>
Refusal refusal_of_face_split(const Mesh& mesh, Halfedge h) {
  if (!knows(mesh, h)) return Refusal::no_such_edge;
  if (mesh.on_boundary(h)) return Refusal::boundary_edge;
  return refusal_of_split(mesh, split_into_face(mesh, h));
}
template <class Mesh, class Halfedge = typename Mesh::Halfedge>
Refusal refusal_of_bisection(const Mesh& mesh, Halfedge h) {
  return knows(mesh, h) ? refusal_of_split(mesh, split_on_edge(mesh, h)) : Refusal::no_such_edge;
}
template <class Mesh, class Halfedge = typename Mesh::Halfedge>
Refusal refusal_of_removal(const Mesh& mesh, Halfedge chord, std::size_t interior, std::size_t boundary) {
  const Refusal refusal = refusal_of_collapse(mesh, chord);
  if (refusal != Refusal::granted) return refusal;
  return head_has(mesh, chord, interior, boundary) ? Refusal::granted : Refusal::other_valence;
}

}  // namespace detail

template <NamesNewVertices Mesh>
Rewrite<typename Mesh::Halfedge> split_face(Mesh& mesh, typename Mesh::Halfedge h) {
  const auto where = detail::split_into_face(mesh, h);
  RESTRIP_ASSERT(detail::refusal_of_split(mesh, where) == Refusal::granted, "split_face",
                 describe(detail::refusal_of_split(mesh, where)));
  return detail::rewrite_patch(mesh, tables::split_face, detail::one_face(mesh, h), [&] {
    const auto chord = mesh.insert_vertex(where);
    return std::pair{chord, detail::three_faces(mesh, chord)};
  });
}

template <CollapsibleMesh Mesh>
Rewrite<typename Mesh::Halfedge> join_faces(Mesh& mesh, typename Mesh::Halfedge chord) {
  RESTRIP_ASSERT(detail::refusal_of_removal(mesh, chord, 3, 0) == Refusal::granted, "join_faces",
                 describe(detail::refusal_of_removal(mesh, chord, 3, 0)));
  return detail::rewrite_patch(mesh, tables::join_faces, detail::three_faces(mesh, chord), [&] {
    const auto spoke = mesh.remove_vertex(chord);
    return std::pair{spoke, detail::one_face(mesh, mesh.next(mesh.opposite(spoke)))};
  });
}

template <NamesNewVertices Mesh>
Rewrite<typename Mesh::Halfedge> bisect(Mesh& mesh, typename Mesh::Halfedge h) {
  const auto where = detail::split_on_edge(mesh, h);
  RESTRIP_ASSERT(detail::refusal_of_split(mesh, where) == Refusal::granted, "bisect",
                 describe(detail::refusal_of_split(mesh, where)));
  if (where.spokes == decltype(where.spokes)::both)
    return detail::rewrite_patch(mesh, tables::bisect, detail::two_beside_edge(mesh, h), [&] {
      const auto chord = mesh.insert_vertex(where);
      return std::pair{chord, detail::four_around_vertex(mesh, chord)};
    });
  // Port 0 of two_on_boundary() is that of the triangle away from v_s.
  auto before = detail::one_on_boundary(mesh, mesh.on_boundary(h) ? mesh.opposite(h) : h);
  if (mesh.on_boundary(h)) std::swap(before.ports[0], before.ports[1]);
  return detail::rewrite_patch(mesh, tables::bisect_boundary, before, [&] {
    const auto chord = mesh.insert_vertex(where);
    return std::pair{chord, detail::two_on_boundary(mesh, chord)};
  });
}

template <CollapsibleMesh Mesh>
Rewrite<typename Mesh::Halfedge> merge(Mesh& mesh, typename Mesh::Halfedge chord) {
  RESTRIP_ASSERT(detail::refusal_of_removal(mesh, chord, 4, 2) == Refusal::granted, "merge",
                 describe(detail::refusal_of_removal(mesh, chord, 4, 2)));
  const bool no_left = mesh.on_boundary(chord);
  if (!no_left && !mesh.on_boundary(mesh.opposite(chord)))
    return detail::rewrite_patch(mesh, tables::merge, detail::four_around_vertex(mesh, chord), [&] {
      const auto edge = mesh.next(mesh.opposite(mesh.remove_vertex(chord)));
      return std::pair{edge, detail::two_beside_edge(mesh, edge)};
    });
  return detail::rewrite_patch(mesh, tables::merge_boundary, detail::two_on_boundary(mesh, chord), [&] {
    const auto spoke = mesh.remove_vertex(chord);
    // To the apex, past which the edge on the boundary comes, or before which.
    const auto inside = no_left ? mesh.next(mesh.next(spoke)) : mesh.next(mesh.opposite(spoke));
    auto after = detail::one_on_boundary(mesh, inside);
    if (no_left) std::swap(after.ports[0], after.ports[1]);
    return std::pair{no_left ? mesh.opposite(inside) : inside, after};
  });
}

inline Refusal check_split_face(const StripMesh& mesh, StripMesh::Halfedge h) {
  return detail::refusal_of_face_split(mesh, h);
}

inline Refusal check_join_faces(const StripMesh& mesh, StripMesh::Halfedge chord) {
  return detail::refusal_of_removal(mesh, chord, 3, 0);
}

inline Refusal check_bisect(const StripMesh& mesh, StripMesh::Halfedge h) {
  return detail::refusal_of_bisection(mesh, h);
}

inline Refusal check_merge(const StripMesh& mesh, StripMesh::Halfedge chord) {
  return detail::refusal_of_removal(mesh, chord, 4, 2);
}

inline Checked checked_split_face(StripMesh& mesh, StripMesh::Halfedge h) {
  return detail::done_if_granted(check_split_face(mesh, h), [&] { return split_face(mesh, h); });
}

inline Checked checked_join_faces(StripMesh& mesh, StripMesh::Halfedge chord) {
  return detail::done_if_granted(check_join_faces(mesh, chord), [&] { return join_faces(mesh, chord); });
}

inline Checked checked_bisect(StripMesh& mesh, StripMesh::Halfedge h) {
  return detail::done_if_granted(check_bisect(mesh, h), [&] { return bisect(mesh, h); });
}

inline Checked checked_merge(StripMesh& mesh, StripMesh::Halfedge chord) {
  return detail::done_if_granted(check_merge(mesh, chord), [&] { return merge(mesh, chord); });
}

}  // namespace restrip
