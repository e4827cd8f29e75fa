// Included by refine.hpp. First sides are as in tables/operations/*.json.
#pragma once

#include <cstddef>
#include <utility>

#include "restrip/operations/apply.hpp"
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

/// apply() for a change() that returns Rewrite::halfedge, and the first side after it.
template <class Mesh, class Table, class Choose, class Change>
Rewrite<typename Mesh::Halfedge> rewrite_patch(Mesh& mesh, const Table& table, typename Mesh::Halfedge where,
                                               Choose& choose, Change&& change) {
  typename Mesh::Halfedge reported{};
  auto done = apply_unchecked(
      mesh, table, where,
      [&](const auto& /*patch*/) {
        const auto [halfedge, first] = change();
        reported = halfedge;
        return first;
      },
      choose);
  done.halfedge = reported;
  return done;
}

/// Four triangles are around v_t of the chord v_s -> v_t, as after bisect(): the side opposite v_t of the one that
/// follows A.
template <class Mesh, class Halfedge = typename Mesh::Halfedge>
Halfedge first_around(const Mesh& mesh, Halfedge chord) {
  return mesh.next(mesh.next(mesh.opposite(mesh.next(chord))));
}

/// Two triangles are at v_t, and the chord v_s -> v_t, or its opposite, is on the boundary: the side on the boundary
/// that leaves v_t.
template <class Mesh, class Halfedge = typename Mesh::Halfedge>
Halfedge first_on_boundary(const Mesh& mesh, Halfedge chord) {
  return mesh.on_boundary(chord) ? mesh.opposite(chord) : mesh.next(mesh.opposite(mesh.next(chord)));
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
/// Also whether v_t of the chord v_s -> v_t has this many triangles: as an interior vertex, or as the end of an edge of
/// the boundary.
template <class Mesh, class Halfedge = typename Mesh::Halfedge>
Refusal refusal_of_removal(const Mesh& mesh, Halfedge chord, std::size_t interior, std::size_t boundary) {
  const Refusal refusal = refusal_of_collapse(mesh, chord);
  if (refusal != Refusal::granted) return refusal;
  const Halfedge back = mesh.opposite(chord);
  const FanSize head = fan_size(mesh, back, back);
  const bool on_rim = mesh.on_boundary(chord) || mesh.on_boundary(back);
  const bool fits = head.closed ? head.triangles == interior : head.triangles == boundary && on_rim;
  return fits ? Refusal::granted : Refusal::other_valence;
}

template <class Mesh, class Choose>
Rewrite<typename Mesh::Halfedge> split_face_with(Mesh& mesh, typename Mesh::Halfedge h, Choose&& choose) {
  const auto where = split_into_face(mesh, h);
  return rewrite_patch(mesh, tables::split_face_rules, h, choose, [&] {
    const auto chord = mesh.insert_vertex(where);
    return std::pair{chord, mesh.next(mesh.opposite(chord))};
  });
}

template <class Mesh, class Choose>
Rewrite<typename Mesh::Halfedge> join_faces_with(Mesh& mesh, typename Mesh::Halfedge chord, Choose&& choose) {
  return rewrite_patch(mesh, tables::join_faces_rules, mesh.opposite(chord), choose, [&] {
    const auto spoke = mesh.remove_vertex(chord);
    return std::pair{spoke, mesh.next(mesh.opposite(spoke))};
  });
}

template <class Mesh, class Choose>
Rewrite<typename Mesh::Halfedge> bisect_with(Mesh& mesh, typename Mesh::Halfedge h, Choose&& choose) {
  const auto where = split_on_edge(mesh, h);
  if (where.spokes == decltype(where.spokes)::both)
    return rewrite_patch(mesh, tables::bisect_rules, h, choose, [&] {
      const auto chord = mesh.insert_vertex(where);
      return std::pair{chord, first_around(mesh, chord)};
    });
  return rewrite_patch(mesh, tables::bisect_boundary_rules, mesh.on_boundary(h) ? mesh.opposite(h) : h, choose, [&] {
    const auto chord = mesh.insert_vertex(where);
    return std::pair{chord, first_on_boundary(mesh, chord)};
  });
}

template <class Mesh, class Choose>
Rewrite<typename Mesh::Halfedge> merge_with(Mesh& mesh, typename Mesh::Halfedge chord, Choose&& choose) {
  const bool no_left = mesh.on_boundary(chord);
  if (!no_left && !mesh.on_boundary(mesh.opposite(chord)))
    return rewrite_patch(mesh, tables::merge_rules, first_around(mesh, chord), choose, [&] {
      const auto edge = mesh.next(mesh.opposite(mesh.remove_vertex(chord)));
      return std::pair{edge, edge};
    });
  return rewrite_patch(mesh, tables::merge_boundary_rules, first_on_boundary(mesh, chord), choose, [&] {
    const auto spoke = mesh.remove_vertex(chord);
    // To the apex; the edge on the boundary comes after or before it.
    const auto inside = no_left ? mesh.next(mesh.next(spoke)) : mesh.next(mesh.opposite(spoke));
    return std::pair{no_left ? mesh.opposite(inside) : inside, inside};
  });
}

}  // namespace detail

template <NamesNewVertices Mesh>
Rewrite<typename Mesh::Halfedge> split_face(Mesh& mesh, typename Mesh::Halfedge h) {
  RESTRIP_ASSERT_GRANTED(detail::refusal_of_face_split(mesh, h), "split_face");
  return detail::split_face_with(mesh, h, detail::TakeRule{});
}

template <CollapsibleMesh Mesh>
Rewrite<typename Mesh::Halfedge> join_faces(Mesh& mesh, typename Mesh::Halfedge chord) {
  RESTRIP_ASSERT_GRANTED(detail::refusal_of_removal(mesh, chord, 3, 0), "join_faces");
  return detail::join_faces_with(mesh, chord, detail::TakeRule{});
}

template <NamesNewVertices Mesh>
Rewrite<typename Mesh::Halfedge> bisect(Mesh& mesh, typename Mesh::Halfedge h) {
  RESTRIP_ASSERT_GRANTED(detail::refusal_of_bisection(mesh, h), "bisect");
  return detail::bisect_with(mesh, h, detail::TakeRule{});
}

template <CollapsibleMesh Mesh>
Rewrite<typename Mesh::Halfedge> merge(Mesh& mesh, typename Mesh::Halfedge chord) {
  RESTRIP_ASSERT_GRANTED(detail::refusal_of_removal(mesh, chord, 4, 2), "merge");
  return detail::merge_with(mesh, chord, detail::TakeRule{});
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

template <CheckedTarget Target>
detail::CheckedOf<Target> checked_split_face(Target& target, detail::HalfedgeOf<Target> h) {
  return detail::with_vertex(
      target, detail::done_if_granted(
                  target, detail::refusal_of_face_split(detail::mesh_of(target), h),
                  [&](auto& mesh) { return split_face(mesh, h); }, [&](auto& keeper) { return keeper.split_face(h); }));
}

template <CheckedTarget Target>
detail::CheckedOf<Target> checked_join_faces(Target& target, detail::HalfedgeOf<Target> chord) {
  return detail::done_if_granted(
      target, detail::refusal_of_removal(detail::mesh_of(target), chord, 3, 0),
      [&](auto& mesh) { return join_faces(mesh, chord); }, [&](auto& keeper) { return keeper.join_faces(chord); });
}

template <CheckedTarget Target>
detail::CheckedOf<Target> checked_bisect(Target& target, detail::HalfedgeOf<Target> h) {
  return detail::with_vertex(
      target, detail::done_if_granted(
                  target, detail::refusal_of_bisection(detail::mesh_of(target), h),
                  [&](auto& mesh) { return bisect(mesh, h); }, [&](auto& keeper) { return keeper.bisect(h); }));
}

template <CheckedTarget Target>
detail::CheckedOf<Target> checked_merge(Target& target, detail::HalfedgeOf<Target> chord) {
  return detail::done_if_granted(
      target, detail::refusal_of_removal(detail::mesh_of(target), chord, 4, 2),
      [&](auto& mesh) { return merge(mesh, chord); }, [&](auto& keeper) { return keeper.merge(chord); });
}

}  // namespace restrip
